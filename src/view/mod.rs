//! Recorded rays as text and as drawings. Nothing here traces a ray of the scene or changes anything.
//!
//! A drawing is a list of marks first, painted or written as SVG second, so that tests compare lists and not pixels.

mod axis;
mod csg_bars;
mod drawing;
mod event_plot;
mod events_of;
mod flights;
mod fonts;
mod formula;
mod frontier_plot;
mod generic_view;
mod heat_map;
mod hit_test;
mod included;
mod interval_bars;
mod labels;
mod log_plot;
mod marks_text;
mod outline;
mod overview;
mod paint;
mod palette;
mod pdf;
mod plane_table;
mod primitive_at;
#[cfg(test)]
mod readable;
#[cfg(test)]
mod sample;
#[cfg(test)]
mod sample_effects;
#[cfg(test)]
mod sample_texture;
mod scan_drawing;
mod scan_text;
mod scene_colour;
mod shading_bars;
mod sheet;
mod side_view;
mod sign_plot;
mod snell_diagram;
mod svg;
mod text;
mod timeline;
mod views;
mod wireframe;

pub use csg_bars::csg_bars;
pub use drawing::{Anchor, Drawing, Form, Frame, Mark, Spot, Stroke, Text};
pub use event_plot::event_plot;
pub use fonts::{Face, Font, FontRole, fonts, has_glyph, text_width};
pub use formula::{FONTS_IN_BROWSERS, Formula, FormulaError, FormulaPixels, SharedLetters, in_words};
pub use frontier_plot::{FrontierPlot, PlotPoint, frontier_plot, seconds};
pub use generic_view::{GenericLook, GenericViewOptions, generic_view};
pub use heat_map::{HeatMap, HeatScale, heat_map};
pub use interval_bars::{interval_bars, probed_interval_bars};
pub use log_plot::{Curve, LogPlot, Panel, Scale, log_plot};
pub use outline::Pen;
pub use overview::{OverviewOptions, Sight, Stand, overview, overview_sight};
pub use paint::{Pixels, paint, png};
pub use palette::{Colour, Palette, Theme};
pub use pdf::pdf;
pub use plane_table::{PlaneTable, plane_table};
pub use scan_drawing::scan_drawing;
pub use scan_text::scan_text;
pub use shading_bars::shading_bars;
pub use side_view::{PlaneView, SectionPlane, SideViewOptions, side_view, side_view_plane};
pub use sign_plot::{ProbedSigns, SignPlotLayout, SignProbe, probed_sign_plot, sign_plot};
pub use snell_diagram::snell_diagram;
pub use svg::{escaped, svg};
pub use text::{
    Detail, DetailLine, Row, beneath, brief, brief_vector, detail, equated, indent, row, significant, span_list,
    tree_text, untold_row,
};
pub use timeline::{AXIS as TIMELINE_AXIS, Timed, TimelineScale, timeline, timeline_height};
pub use views::{ALL_VIEWS, Subject, View, primitive_behind, search_behind};
pub use wireframe::{WireLine, Wireframe};
