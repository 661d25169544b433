//! Which drawings a trace is written with.

use crate::cli::drawn::Theme;
use crate::cli::failure::Failure;
use crate::record::EventId;
use crate::scene::Scene;
use crate::trace::RayTree;
use crate::view::{ALL_VIEWS, Drawing, Subject, View};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// Drawings are this large, in points.
const SIZE: [f64; 2] = [960.0, 600.0];

/// What pictures show.
#[derive(Args, Clone, Debug)]
pub struct ShownArguments {
    /// What a picture shows [default: side; of steps what tells most of each]
    #[arg(long = "view", alias = "drawing", value_name = "VIEW,…", value_delimiter = ',', value_parser = views())]
    views: Vec<&'static View>,
    /// The number of the event that a drawing is about [default: the one that tells most]
    #[arg(long, value_name = "N")]
    event: Option<EventId>,
    /// Colours of drawings
    #[arg(long, value_enum, default_value_t = Theme::Light)]
    pub theme: Theme,
}

/// The names of all views, with what they show.
fn views() -> impl TypedValueParser<Value = &'static View> {
    let values = ALL_VIEWS.iter().map(|view| PossibleValue::new(view.name).help(view.about));
    let named = |name: String| View::named(&name).ok_or_else(|| format!("there is no view {name}"));
    PossibleValuesParser::new(values).try_map(named)
}

impl ShownArguments {
    /// The views that were asked for.
    pub fn views(&self) -> &[&'static View] {
        &self.views
    }

    /// Whether an event was asked for.
    pub const fn has_event(&self) -> bool {
        self.event.is_some()
    }

    /// The event that was asked for, if the tree has it.
    pub fn event(&self, tree: &RayTree) -> Result<Option<EventId>, Failure> {
        match self.event {
            Some(event) if event >= tree.end() => Err(Failure::usage(format!(
                "there is no event {event}; this ray's last one is {} (--format json lists them)",
                tree.end().saturating_sub(1)
            ))),
            event => Ok(event),
        }
    }

    /// The drawings, the scene's where none were asked for.
    pub fn drawn(&self, scene: &Scene, tree: &RayTree) -> Result<Vec<Drawing>, Failure> {
        let event = self.event(tree)?;
        let side = ALL_VIEWS.iter().take(1);
        let views: Vec<&View> = if self.views.is_empty() { side.collect() } else { self.views.clone() };
        let subject = Subject { scene, tree, event: event.unwrap_or_default(), size: SIZE, theme: self.theme.into() };
        let draw = |view: &View| {
            let drawing = if event.is_some() { view.draw(&subject) } else { view.draw_telling(&subject) };
            drawing.ok_or_else(|| {
                let missing = view.missing;
                Failure::refused(format!("there is nothing to draw: {missing}; try another --pixel, or --view side"))
            })
        };
        views.into_iter().map(draw).collect()
    }
}
