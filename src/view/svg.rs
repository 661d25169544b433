//! Drawings as SVG text.

use super::drawing::{Anchor, Drawing, Form, Frame, HALO, Spot, Stroke, Text};
use super::fonts::Face;
use super::outline::Pen;
use super::paint::arrow_head;
use super::palette::Colour;
use crate::math::portable;
use std::fmt::Write as _;

/// A drawing as an SVG document. Texts stay texts, so that they can be searched, read aloud and edited.
#[must_use]
pub fn svg(drawing: &Drawing) -> String {
    let (width, height) = (number(drawing.width), number(drawing.height));
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         stroke-linejoin=\"round\" fill=\"none\">\n<rect width=\"{width}\" height=\"{height}\"{}/>\n",
        paint("fill", drawing.background)
    );
    if !drawing.description.is_empty() {
        let _ = writeln!(out, "<desc>{}</desc>", escaped(&drawing.description));
    }
    for mark in &drawing.marks {
        element(&mut out, &mark.form);
        out.push('\n');
    }
    out.push_str("</svg>\n");
    out
}

fn element(out: &mut String, form: &Form) {
    let _ = match form {
        Form::Line { points, stroke } => write!(out, "<path d=\"{}\"{}/>", path(points, false), line(stroke)),
        Form::Area { rings, fill } => {
            let rings: String = rings.iter().map(|ring| path(ring, true)).collect();
            write!(out, "<path d=\"{rings}\" fill-rule=\"evenodd\"{}/>", paint("fill", *fill))
        }
        Form::Circle { centre: [x, y], radius, fill, stroke } => {
            let (x, y, r) = (number(*x), number(*y), number(*radius));
            write!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{}/>", area(*fill, *stroke))
        }
        Form::Arc { centre, radius, angles, stroke } => {
            write!(out, "<path d=\"{}\"{}/>", arc(*centre, *radius, *angles), line(stroke))
        }
        Form::Arrow { from, to, head, stroke } => {
            let (shaft_end, tip) = arrow_head(*from, *to, *head);
            let (shaft, tip) = (path(&[*from, shaft_end], false), path(&tip, true));
            write!(out, "<path d=\"{shaft}\"{}/><path d=\"{tip}\"{}/>", line(stroke), paint("fill", stroke.colour))
        }
        Form::Rect { frame: Frame { low, high }, fill, stroke } => {
            let [x, y, w, h] = [low[0], low[1], high[0] - low[0], high[1] - low[1]].map(number);
            write!(out, "<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"{}/>", area(*fill, *stroke))
        }
        Form::Text(text) => {
            out.push_str(&text_element(text));
            Ok(())
        }
        Form::Outline { steps, fill } => {
            write!(out, "<path d=\"{}\"{}/>", outline(steps, number), paint("fill", *fill))
        }
    };
}

fn text_element(text: &Text) -> String {
    let (family, weight) = match text.face {
        Face::Sans => ("Noto Sans,Noto Sans Math,DejaVu Sans,Segoe UI,sans-serif", ""),
        Face::Bold => ("Noto Sans,Noto Sans Math,DejaVu Sans,Segoe UI,sans-serif", " font-weight=\"bold\""),
        Face::Mono => ("Noto Sans Mono,DejaVu Sans Mono,Consolas,monospace", ""),
    };
    let anchor = match text.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let halo = text.halo.map(|halo| {
        let width = number(HALO * text.size);
        format!(" paint-order=\"stroke\" stroke-width=\"{width}\"{}", paint("stroke", halo))
    });
    format!(
        "<text x=\"{}\" y=\"{}\" font-family=\"{family}\" font-size=\"{}\"{weight} text-anchor=\"{anchor}\"{}{}>{}</text>",
        number(text.at[0]),
        number(text.at[1]),
        number(text.size),
        paint("fill", text.colour),
        halo.unwrap_or_default(),
        escaped(&text.text)
    )
}

/// Characters that mean something in XML are written as entities; those that XML forbids are left out.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\u{fffe}' | '\u{ffff}' => {}
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// Hundredths of a point, without trailing zeros.
fn number(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn paint(attribute: &str, colour: Colour) -> String {
    let Colour { r, g, b, a } = colour;
    let opacity =
        if a == 255 { String::new() } else { format!(" {attribute}-opacity=\"{}\"", number(f64::from(a) / 255.0)) };
    format!(" {attribute}=\"#{r:02x}{g:02x}{b:02x}\"{opacity}")
}

fn line(stroke: &Stroke) -> String {
    let dash = stroke.dash.map(|[on, off]| format!(" stroke-dasharray=\"{} {}\"", number(on), number(off)));
    let cap = if stroke.dash.is_some() { "" } else { " stroke-linecap=\"round\"" };
    format!(
        "{} stroke-width=\"{}\"{}{cap}",
        paint("stroke", stroke.colour),
        number(stroke.width),
        dash.unwrap_or_default()
    )
}

fn area(fill: Option<Colour>, stroke: Option<Stroke>) -> String {
    let fill = fill.map(|fill| paint("fill", fill)).unwrap_or_default();
    fill + &stroke.map(|stroke| line(&stroke)).unwrap_or_default()
}

fn path(points: &[Spot], close: bool) -> String {
    let mut out = String::new();
    for (i, &[x, y]) in points.iter().enumerate() {
        let _ = write!(out, "{}{} {}", if i == 0 { 'M' } else { 'L' }, number(x), number(y));
    }
    if close {
        out.push('Z');
    }
    out
}

/// The way of a pen as path data, its numbers written in the given way.
pub(super) fn outline(steps: &[Pen], number: impl Fn(f64) -> String) -> String {
    let spot = |[x, y]: &Spot| format!("{} {}", number(*x), number(*y));
    let mut out = String::new();
    for step in steps {
        let _ = match step {
            Pen::Move(end) => write!(out, "M{}", spot(end)),
            Pen::Line(end) => write!(out, "L{}", spot(end)),
            Pen::Quad(control, end) => write!(out, "Q{} {}", spot(control), spot(end)),
            Pen::Cubic(one, other, end) => write!(out, "C{} {} {}", spot(one), spot(other), spot(end)),
            Pen::Close => write!(out, "Z"),
        };
    }
    out
}

fn arc(centre: Spot, radius: f64, [from, to]: [f64; 2]) -> String {
    let at =
        |angle: f64| [centre[0] + radius * portable::cos(angle), centre[1] + radius * portable::sin(angle)].map(number);
    let ([x0, y0], [x1, y1], r) = (at(from), at(to), number(radius));
    let large = u8::from((to - from).abs() > std::f64::consts::PI);
    let sweep = u8::from(to > from);
    format!("M{x0} {y0}A{r} {r} 0 {large} {sweep} {x1} {y1}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Theme;

    #[test]
    fn names_with_xml_in_them_do_no_harm() {
        assert_eq!(escaped("a<b> & \"c\"\u{7}'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;");
    }

    #[test]
    fn a_drawing_is_one_document_with_its_marks_in_order() {
        let palette = Theme::Light.palette();
        let mut drawing = Drawing::new([100.0, 50.5], palette.ground);
        let stroke = Stroke::dashed(palette.ink, 1.5, [4.0, 2.0]);
        drawing.put(Form::Line { points: vec![[0.0, -0.001], [10.0, 20.255]], stroke }, None);
        drawing
            .put(Form::Circle { centre: [5.0, 5.0], radius: 2.0, fill: Some(palette.ink.faded(0.5)), stroke: None }, 3);
        let text = svg(&drawing);
        assert!(text.contains("viewBox=\"0 0 100 50.5\""), "{text}");
        let line =
            text.find("<path d=\"M0 0L10 20.25\" stroke=\"#1c1f24\" stroke-width=\"1.5\" stroke-dasharray=\"4 2\"/>");
        let circle = text.find("<circle cx=\"5\" cy=\"5\" r=\"2\" fill=\"#1c1f24\" fill-opacity=\"0.5\"/>");
        assert!(line.is_some() && circle.is_some() && line < circle, "{text}");
    }
}
