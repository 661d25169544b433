//! rayscope: a workbench that shows the whole story of a ray.
//!
//! Data flows one way: scene file → [`scene`] → [`trace`] → event tree → [`view`] → command line or workbench. The
//! layers, from the bottom: [`record`], [`math`], then [`shape`], [`csg`], [`optics`], [`sample`] and [`texture`], then [`scene`], [`trace`],
//! [`view`], [`accuracy`], [`laboratory`], [`ledger`], [`peer`], [`query`] and [`lesson`], then [`book`], and on top [`cli`] and `app`. [`folder`] reads the pictures
//! beside a scene file, [`lesson_folder`] lessons on disk, and [`cpu_time`] tells how long a thread has worked.

#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout, clippy::print_stderr)]

pub mod accuracy;
#[cfg(feature = "workbench")]
pub mod app;
pub mod book;
#[cfg(not(target_arch = "wasm32"))]
pub mod cli;
pub mod compare;
pub mod cpu_time;
pub mod csg;
pub mod document;
pub mod folder;
pub mod laboratory;
pub mod ledger;
pub mod lesson;
pub mod lesson_folder;
pub mod math;
pub mod optics;
pub mod peer;
pub mod query;
pub mod record;
pub mod sample;
pub mod scene;
pub mod shape;
pub mod share;
pub mod story;
pub mod texture;
pub mod trace;
pub mod view;
pub mod words;
