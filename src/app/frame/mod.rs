//! What all panels stand in: the top bar, cards with headers, colours and fonts, messages, background work.

pub mod background;
pub mod file_dialog;
pub mod layout;
pub mod panel;
pub mod problem;
pub mod scene_menu;
pub mod split;
pub mod theme;
pub mod top_bar;
