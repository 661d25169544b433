//! What all panels stand in: the top bar, cards with headers, colours and fonts, messages, background work.

pub mod background;
pub mod code;
pub mod empty;
pub mod file_dialog;
pub mod key_names;
pub mod menu;
pub mod problem;
pub mod scene_menu;
pub mod task;
pub mod theme;
pub mod ticks;
pub mod top_bar;
pub mod words;
