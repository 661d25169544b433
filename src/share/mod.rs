//! What leaves the workbench for other people: links, worked examples, slides, moving pictures.
//!
//! Everything here makes bytes or text and writes nothing; the command line and the workbench put it into files.

pub mod link;
