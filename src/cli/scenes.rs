//! `rayscope scenes`: what comes with the program.

use super::failure::Failure;
use super::output::Output;
use crate::scene::{embedded_scenes, load};
use clap::{Args, ValueEnum};
use serde::Serialize;

/// List the scenes that come with the program
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope scenes
  rayscope scenes --format json")]
pub struct Scenes {
    /// How to list them
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    /// A table
    Text,
    /// A JSON array of {"name", "title", "sections"}
    Json,
}

#[derive(Serialize)]
struct Listed {
    name: String,
    title: String,
    sections: Vec<String>,
}

impl Scenes {
    /// Prints the list.
    pub fn run(&self) -> Result<(), Failure> {
        let scenes = listed()?;
        let text = match self.format {
            Format::Text => table(&scenes),
            Format::Json => json(&scenes)?,
        };
        Output::Standard.write(text.as_bytes())
    }
}

fn listed() -> Result<Vec<Listed>, Failure> {
    let list = |embedded: crate::scene::EmbeddedScene| {
        let scene = load(embedded.text, &embedded.name).map_err(|errors| Failure::usage(errors.to_string()))?;
        Ok(Listed { name: embedded.name, title: scene.title, sections: scene.sections })
    };
    embedded_scenes().into_iter().map(list).collect()
}

fn table(scenes: &[Listed]) -> String {
    let width = scenes.iter().map(|scene| scene.name.chars().count()).max().unwrap_or(0);
    let mut text = String::new();
    for Listed { name, title, sections } in scenes {
        let sections: Vec<String> = sections.iter().map(|section| format!("§ {section}")).collect();
        let line = format!("{name:width$}  {title}  {}", sections.join(", "));
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

fn json(scenes: &[Listed]) -> Result<String, Failure> {
    let text = serde_json::to_string_pretty(scenes).map_err(|error| Failure::refused(error.to_string()))?;
    Ok(text + "\n")
}
