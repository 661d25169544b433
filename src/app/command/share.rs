//! Links, copies and files for other people.

use super::Commands;
use crate::app::share::{Aim, Ending, Product};
use crate::app::workbench::Workbench;
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// A command about sharing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShareCommand {
    /// Copies a link to what is seen.
    CopyLink,
    /// Asks for a link to follow.
    OpenLink,
    /// Copies the trace as text.
    CopyText,
    /// Copies the worked example.
    CopyMarkdown,
    /// Copies the drawing of the panel that is used.
    CopyImage,
    /// Saves that drawing.
    SaveSvg,
    /// Saves that drawing.
    SavePng,
    /// Saves that drawing.
    SavePdf,
    /// Saves the trace as text.
    SaveText,
    /// Saves the trace as data.
    SaveJson,
    /// Saves the worked example.
    SaveMarkdown,
    /// Saves slides for a browser.
    SaveSlides,
    /// Saves slides as PDF.
    SaveSlidesPdf,
    /// Saves the steps as a moving picture.
    SaveGif,
    /// Saves the steps as a moving picture.
    SaveApng,
}

impl ShareCommand {
    /// What is made, of those that make something.
    fn product(self, workbench: &Workbench) -> Option<(Product, Aim)> {
        let view = |ending| workbench.current_view().map(|view| Product::View(view, ending));
        Some(match self {
            Self::CopyLink | Self::OpenLink => return None,
            Self::CopyText => (Product::Text, Aim::Clipboard),
            Self::CopyMarkdown => (Product::Markdown, Aim::Clipboard),
            Self::CopyImage => (view(Ending::Png)?, Aim::Clipboard),
            Self::SaveSvg => (view(Ending::Svg)?, Aim::Ask),
            Self::SavePng => (view(Ending::Png)?, Aim::Ask),
            Self::SavePdf => (view(Ending::Pdf)?, Aim::Ask),
            Self::SaveText => (Product::Text, Aim::Ask),
            Self::SaveJson => (Product::Json, Aim::Ask),
            Self::SaveMarkdown => (Product::Markdown, Aim::Ask),
            Self::SaveSlides => (Product::Slides, Aim::Ask),
            Self::SaveSlidesPdf => (Product::SlidesPdf, Aim::Ask),
            Self::SaveGif => (Product::Gif, Aim::Ask),
            Self::SaveApng => (Product::Apng, Aim::Ask),
        })
    }
}

impl Commands for ShareCommand {
    const ALL: &'static [Self] = &[
        Self::CopyLink,
        Self::OpenLink,
        Self::CopyText,
        Self::CopyMarkdown,
        Self::CopyImage,
        Self::SaveSvg,
        Self::SavePng,
        Self::SavePdf,
        Self::SaveText,
        Self::SaveJson,
        Self::SaveMarkdown,
        Self::SaveSlides,
        Self::SaveSlidesPdf,
        Self::SaveGif,
        Self::SaveApng,
    ];

    fn word(self) -> &'static str {
        match self {
            Self::CopyLink => "share-copy-link",
            Self::OpenLink => "share-open-link",
            Self::CopyText => "share-copy-text",
            Self::CopyMarkdown => "share-copy-markdown",
            Self::CopyImage => "share-copy-image",
            Self::SaveSvg => "share-save-svg",
            Self::SavePng => "share-save-png",
            Self::SavePdf => "share-save-pdf",
            Self::SaveText => "share-save-text",
            Self::SaveJson => "share-save-json",
            Self::SaveMarkdown => "share-save-markdown",
            Self::SaveSlides => "share-save-slides",
            Self::SaveSlidesPdf => "share-save-slides-pdf",
            Self::SaveGif => "share-save-gif",
            Self::SaveApng => "share-save-apng",
        }
    }

    fn key(self) -> Option<KeyboardShortcut> {
        let shifted = |key| Some(KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key));
        match self {
            Self::CopyLink => shifted(Key::L),
            Self::OpenLink => Some(KeyboardShortcut::new(Modifiers::COMMAND, Key::L)),
            Self::CopyText => shifted(Key::T),
            Self::CopyImage => shifted(Key::I),
            _ => None,
        }
    }

    fn is_possible(self, workbench: &Workbench) -> bool {
        match self {
            Self::OpenLink => true,
            Self::CopyLink => workbench.scene().is_some(),
            _ => workbench.recording().is_some() && !workbench.is_sharing(),
        }
    }

    fn run(self, workbench: &mut Workbench, ctx: &Context) {
        match (self, self.product(workbench)) {
            (Self::CopyLink, _) => workbench.copy_link(ctx),
            (Self::OpenLink, _) => workbench.ask_for_link(),
            (_, Some((product, aim))) => workbench.share(product, aim),
            (_, None) => {}
        }
    }
}
