//! The opening of a lens.

/// The shape of the opening, within the unit disc.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Aperture {
    /// The disc itself.
    #[default]
    Disc,
    /// A regular polygon with its corners on the unit circle.
    Polygon {
        /// How many sides it has, 3 or more.
        sides: u32,
        /// How far it is turned anticlockwise from a corner on the right, in radians.
        turn: f64,
    },
}

impl Aperture {
    /// The word for it, as scene files spell it.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Disc => "disc",
            Self::Polygon { .. } => "polygon",
        }
    }
}
