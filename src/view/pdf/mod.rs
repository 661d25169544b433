//! Drawings as a PDF document: one page for each, with real text in embedded fonts, so that it can be searched and copied.
//!
//! Nothing in the file tells when or where it was made: the same drawings give the same bytes. Each page is one tagged
//! figure whose alternative text is the drawing's description. After ISO 32000-1:2008 (PDF 1.7); section numbers in this
//! folder are that standard's.

mod content;
mod embedded;
#[cfg(test)]
mod tests;

use super::drawing::Drawing;
use content::{PageContent, alpha_name, content_of};
use embedded::FontSet;
use pdf_writer::types::StructRole;
use pdf_writer::{Filter, Finish, Name, Pdf, Rect, Ref, TextStr};
use std::collections::BTreeSet;

/// The streams' compression, 0 to 10: beyond 9 it takes longer for next to nothing.
const COMPRESSION: u8 = 9;

/// A PDF of that title with one page for each drawing, as large as the drawing.
#[must_use]
pub fn pdf(title: &str, drawings: &[Drawing]) -> Vec<u8> {
    let mut fonts = FontSet::default();
    let contents: Vec<PageContent> = drawings.iter().map(|drawing| content_of(drawing, &mut fonts)).collect();
    let mut document = Document { pdf: Pdf::new(), next: 1 };
    let [catalog, pages, tree, parents] = std::array::from_fn(|_| document.new_ref());
    document.catalog(catalog, [pages, tree], title);
    let resources = document.resources(&mut fonts, &contents);
    let mut kids = Vec::new();
    let mut figures = Vec::new();
    for (drawing, content) in drawings.iter().zip(&contents) {
        let (page, figure) = (document.new_ref(), document.new_ref());
        let place = Page { own: page, figure, pages, tree, resources, key: kids.len() };
        document.page(&place, drawing, content);
        kids.push(page);
        figures.push(figure);
    }
    document.structure(tree, parents, &figures);
    document.pdf.pages(pages).count(number(kids.len())).kids(kids);
    document.pdf.finish()
}

/// A count as PDF writes it; no document has 2³¹ pages.
fn number(count: usize) -> i32 {
    i32::try_from(count).unwrap_or(i32::MAX)
}

/// The objects that a page hangs together with.
struct Page {
    own: Ref,
    figure: Ref,
    pages: Ref,
    tree: Ref,
    resources: Ref,
    /// Its place among the pages, from 0.
    key: usize,
}

/// The file as it grows.
struct Document {
    pdf: Pdf,
    next: i32,
}

impl Document {
    fn new_ref(&mut self) -> Ref {
        let id = Ref::new(self.next);
        self.next += 1;
        id
    }

    fn catalog(&mut self, catalog: Ref, [pages, tree]: [Ref; 2], title: &str) {
        let info = self.new_ref();
        self.pdf.document_info(info).title(TextStr(title)).producer(TextStr("rayscope"));
        let mut root = self.pdf.catalog(catalog);
        root.pages(pages).lang(TextStr("en"));
        root.pair(Name(b"StructTreeRoot"), tree);
        root.mark_info().marked(true);
        root.viewer_preferences().display_doc_title(true);
    }

    /// A packed stream.
    fn stream(&mut self, bytes: &[u8]) -> Ref {
        let id = self.new_ref();
        let packed = miniz_oxide::deflate::compress_to_vec_zlib(bytes, COMPRESSION);
        self.pdf.stream(id, &packed).filter(Filter::FlateDecode);
        id
    }

    /// What all pages draw from: fonts and opacities.
    fn resources(&mut self, fonts: &mut FontSet, contents: &[PageContent]) -> Ref {
        let embedded: Vec<_> = fonts.fonts().map(|font| (font.name(), self.font(font))).collect();
        let alphas: BTreeSet<u8> = contents.iter().flat_map(|content| content.alphas.iter().copied()).collect();
        let id = self.new_ref();
        let mut dictionary = self.pdf.indirect(id).dict();
        let mut names = dictionary.insert(Name(b"Font")).dict();
        for (name, font) in &embedded {
            names.pair(Name(name.as_bytes()), *font);
        }
        names.finish();
        let mut states = dictionary.insert(Name(b"ExtGState")).dict();
        for alpha in alphas {
            let opacity = f32::from(alpha) / 255.0;
            let name = alpha_name(alpha);
            let mut state = states.insert(Name(name.as_bytes())).dict();
            state.pair(Name(b"CA"), opacity).pair(Name(b"ca"), opacity);
        }
        states.finish();
        id
    }

    fn page(&mut self, place: &Page, drawing: &Drawing, content: &PageContent) {
        let stream = self.stream(&content.bytes);
        let mut page = self.pdf.page(place.own);
        page.parent(place.pages).contents(stream).struct_parents(number(place.key));
        page.media_box(Rect::new(0.0, 0.0, content::narrow(drawing.width), content::narrow(drawing.height)));
        page.pair(Name(b"Resources"), place.resources);
        page.finish();
        let mut figure = self.pdf.struct_element(place.figure);
        figure.kind(StructRole::Figure).parent(place.tree).page(place.own);
        figure.alt(TextStr(&drawing.in_words()));
        figure.children().marked_content_ref().marked_content_id(content::FIGURE);
    }

    /// The tree of tagged content (§ 14.7): a figure for each page, and which figure a page's content belongs to.
    fn structure(&mut self, tree: Ref, parents: Ref, figures: &[Ref]) {
        let mut root = self.pdf.indirect(tree).start::<pdf_writer::writers::StructTreeRoot>();
        root.children().items(figures.iter().copied());
        root.pair(Name(b"ParentTree"), parents);
        root.parent_tree_next_key(number(figures.len()));
        root.finish();
        let mut dictionary = self.pdf.indirect(parents).dict();
        let mut numbers = dictionary.insert(Name(b"Nums")).array();
        for (key, figure) in figures.iter().enumerate() {
            numbers.item(number(key));
            numbers.push().array().item(*figure);
        }
    }
}
