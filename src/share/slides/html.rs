//! Slides as one page of HTML that asks for nothing from outside. Without its script all slides stand below each other.

use super::MOST_SLIDES;
use crate::record::EventId;
use crate::share::figures::{Figure, figures_of};
use crate::share::{Account, Cancelled, Steps, Watch};
use crate::view::{DetailLine, Theme, beneath, detail, equated, escaped, row, svg};
use std::fmt::Write as _;

const STYLE: &str = include_str!("../../../assets/slides/slides.css");
const SCRIPT: &str = include_str!("../../../assets/slides/slides.js");

/// The drawings' sizes in points where there is one, and where there are two.
const ALONE: [f64; 2] = [640.0, 440.0];
const IN_PAIR: [f64; 2] = [640.0, 300.0];

/// The slides of a ray as a page: light and dark, with keys, printed one to a sheet.
///
/// # Errors
/// If `watch` says that nobody waits any more.
pub fn slides(account: &Account, watch: Watch) -> Result<String, Cancelled> {
    let steps = account.steps(MOST_SLIDES);
    let title = escaped(&format!("{}, {}", account.title(), account.aim()));
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; \
         script-src 'unsafe-inline'\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1 class=\"talk\">{title}</h1>\n<main>\n"
    );
    for place in 0..steps.events.len() {
        if !watch(place, steps.events.len()) {
            return Err(Cancelled);
        }
        slide(&mut page, account, &steps, place);
    }
    if let Some(words) = steps.left_out_in_words("slides") {
        let _ = writeln!(page, "<p class=\"left-out\">{}</p>", escaped(&words));
    }
    page.push_str("</main>\n");
    if let Some(link) = account.link {
        let _ =
            writeln!(page, "<p class=\"link\">In the workbench: <code>rayscope open '{}'</code></p>", escaped(link));
    }
    let _ = write!(page, "<script>\n{SCRIPT}</script>\n</body>\n</html>\n");
    Ok(page)
}

fn slide(page: &mut String, account: &Account, steps: &Steps, place: usize) {
    let (id, count) = (steps.events[place], steps.events.len());
    let event = account.tree.event(id);
    let (row, detail) = (row(event), detail(event));
    let number = place + 1;
    let _ = write!(
        page,
        "<section class=\"slide\" id=\"{number}\" aria-labelledby=\"title-{number}\">\n<header>\n\
         <p class=\"place\">{} · {} · {number} / {count}</p>\n\
         <h2 id=\"title-{number}\"><span aria-hidden=\"true\">{}</span> {}</h2>\n",
        escaped(account.name),
        escaped(&account.aim()),
        row.icon,
        escaped(&detail.title)
    );
    if !row.numbers.is_empty() {
        let _ = writeln!(page, "<p class=\"numbers\">{}</p>", escaped(&row.numbers));
    }
    let _ = write!(page, "<p class=\"note\">{}</p>\n</header>\n<div class=\"body\">\n", escaped(detail.explanation));
    figures(page, account, id);
    page.push_str("<div class=\"working\">\n");
    for line in beneath(event) {
        working(page, &line);
    }
    let _ = write!(page, "</div>\n</div>\n<footer>{}</footer>\n</section>\n", trail(account, id));
}

/// The events down to this one.
fn trail(account: &Account, id: EventId) -> String {
    let path = account.tree.path(id);
    let labels: Vec<String> = path.into_iter().map(|id| escaped(&row(account.tree.event(id)).label)).collect();
    labels.join(" › ")
}

/// Each drawing twice, for light and for dark; the style shows one of them.
fn figures(page: &mut String, account: &Account, id: EventId) {
    let of_theme = |theme| -> Vec<Figure> {
        figures_of(&Account { theme, ..*account }, id, |count| if count < 2 { ALONE } else { IN_PAIR })
    };
    let [light, dark] = match account.theme {
        Theme::Light | Theme::Dark => [Theme::Light, Theme::Dark],
        Theme::LightContrast | Theme::DarkContrast => [Theme::LightContrast, Theme::DarkContrast],
    };
    let both = of_theme(light).into_iter().zip(of_theme(dark));
    page.push_str("<div class=\"figures\">\n");
    for (light, dark) in both {
        let words = escaped(&light.drawing.in_words());
        let _ = writeln!(page, "<figure role=\"img\" aria-label=\"{words}\">");
        for (class, figure) in [("light", &light), ("dark", &dark)] {
            let picture = svg(&figure.drawing);
            let _ = write!(
                page,
                "{}",
                picture.replacen("<svg ", &format!("<svg class=\"{class}\" aria-hidden=\"true\" "), 1)
            );
        }
        page.push_str("</figure>\n");
    }
    page.push_str("</div>\n");
}

fn working(page: &mut String, line: &DetailLine) {
    match line {
        DetailLine::Pair { name, value } => {
            let _ = writeln!(page, "<p><b>{}</b> {}</p>", escaped(name), escaped(value));
        }
        DetailLine::Working { symbol, formula, numbers, result } => {
            let parts = equated(symbol, [formula, numbers, result]);
            let parts: Vec<String> = parts.iter().map(|part| format!("<span>{}</span>", escaped(part))).collect();
            let _ = writeln!(page, "<p class=\"equation\">{}</p>", parts.join(" = "));
        }
        DetailLine::Table { title, headers, rows } => {
            let cells = |tag: &str, cells: &mut dyn Iterator<Item = &str>| {
                let cells: Vec<String> = cells.map(|cell| format!("<{tag}>{}</{tag}>", escaped(cell))).collect();
                format!("<tr>{}</tr>", cells.concat())
            };
            let head = cells("th", &mut headers.iter().copied());
            let body: String = rows.iter().map(|row| cells("td", &mut row.iter().map(String::as_str))).collect();
            let _ = writeln!(
                page,
                "<div class=\"table\"><table><caption>{}</caption><thead>{head}</thead><tbody>{body}</tbody></table></div>",
                escaped(title)
            );
        }
    }
}
