//! Editing: the text of the scene, the properties of what is in it, moving things in the picture, saving, and what is kept in case of a
//! crash.

pub mod analysis;
pub mod dialog;
pub mod editing;
pub mod editor;
pub mod field;
pub mod finder;
pub mod frame_box;
pub mod glue;
pub mod grasp;
pub mod highlight;
pub mod live;
pub mod mover;
pub mod popup;
pub mod properties;
pub mod recovery;
pub mod saving;
