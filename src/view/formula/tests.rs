use super::*;
use crate::view::{Drawing, Theme, svg};

/// What lessons write.
const FORMULAS: &[&str] = &[
    "x^2",
    r"\frac{a + b}{2}",
    r"\sqrt{B^2 - 4AC}",
    r"\begin{pmatrix} 1 & 0 & 0 \\ 0 & \cos\theta & -\sin\theta \\ 0 & \sin\theta & \cos\theta \end{pmatrix}",
    r"\begin{aligned} t_1 &= \frac{-B - \sqrt{D}}{2A} \\ t_2 &= \frac{-B + \sqrt{D}}{2A} \end{aligned}",
    r"\alpha\beta\gamma\delta\varepsilon\theta\lambda\mu\rho\sigma\varphi\Omega",
    r"\mathbf{n}' = \mathbf{n} + \frac{\partial b}{\partial u}\,(\mathbf{n} \times \mathbf{P}_v)",
    r"\lVert \mathbf{d} \rVert = 1",
    r"\lvert x \rvert^n + \left\lVert \frac{y}{2} \right\rVert",
    r"(S_1 \cup S_2) \setminus C = \{ t \mid d(t) \le 0 \}",
    r"\sum_{i=0}^{n} \frac{1}{2^i}\,\mathrm{noise}(2^i P)",
    r"\begin{cases} 1 & \text{if } t > 0 \\ 0 & \text{otherwise} \end{cases}",
    "t = −0.35 · 1.5^2",
    r"\vec{v} \cdot \hat{n} \ge 0 \Rightarrow 30^\circ",
    r"\overbrace{a + b}^{\text{first}} \underbrace{c}_{k} \boldsymbol{x} \mathcal{L} \mathbb{R}",
    r"\text{surface of S₁} \cup \text{½ · 10⁻³ → “1”}",
    r"\text{§ 6.5: the index is } n_1/n_2 \approx 1{,}000",
];

fn set(latex: &str) -> Formula {
    Formula::typeset(latex, true).unwrap_or_else(|error| panic!("{latex}: {error}"))
}

#[test]
fn what_lessons_write_can_be_set() {
    for latex in FORMULAS {
        let formula = set(latex);
        assert!(formula.width > 0.4 && formula.height > 0.3 && formula.depth >= 0.0, "{latex}: {formula:?}");
        assert!(formula.outlines().count() > 1, "{latex}");
    }
}

#[test]
fn the_box_of_a_formula_holds_all_its_ink() {
    for latex in FORMULAS {
        let formula = set(latex);
        let frame = Frame { low: [0.0, -formula.height], high: [formula.width, formula.depth] }.grown(1e-9);
        for outline in formula.outlines() {
            assert!(frame.holds(&frame_of(&outline).unwrap()), "{latex}");
        }
    }
}

#[test]
fn a_letter_stands_on_the_baseline_and_a_tail_hangs_below_it() {
    let [x, y] = ["x", "y"].map(set);
    // Curved letters reach a hundredth of an em below the line, so that they do not seem to float.
    assert!(x.depth < 0.02, "{}", x.depth);
    assert!((0.19..0.22).contains(&y.depth), "{}", y.depth);
    assert!((x.height - y.height).abs() < 0.02);
}

#[test]
fn digits_are_half_an_em_wide_each() {
    let one = set("1").width;
    assert!((one - 0.5).abs() < 1e-9, "{one}");
    assert!((set("1234").width - 4.0 * one).abs() < 1e-9);
}

#[test]
fn a_fraction_is_higher_in_a_line_of_its_own_than_within_text() {
    let [display, inline] = [true, false].map(|display| Formula::typeset(r"\frac{1}{2}", display).unwrap());
    assert!(display.height > 1.2 * inline.height && display.depth > 1.5 * inline.depth);
}

#[test]
fn a_wrong_command_is_an_error_that_says_where() {
    let error = Formula::typeset(r"x + \fraq{1}{2}", false).unwrap_err();
    assert_eq!((error.at, error.message.as_str()), (Some(4), r"there is no command \fraq"));
    assert_eq!(error.to_string(), r"there is no command \fraq (at character 5 of the formula)");
    assert_eq!(
        Formula::typeset(r"−1 · x · \fraq", false).unwrap_err().at,
        Some(13),
        "bytes of the text as it was written"
    );
    for wrong in [r"\frac{1}{2", "x^", r"\begin{pmatrix} 1 & 2", r"\left( x", "a & b", "}", "", "  "] {
        let error = Formula::typeset(wrong, false).unwrap_err();
        assert!(!error.message.is_empty(), "{wrong}");
    }
}

#[test]
fn what_cannot_be_shown_is_refused_rather_than_left_out() {
    for wrong in [r"\color{red} x", r"\cancel{x}", "界", r"\mathfrak{g}", r"\rule{9999em}{1em}"] {
        assert!(Formula::typeset(wrong, false).is_err(), "{wrong}");
    }
    assert!(Formula::typeset(&"x".repeat(9000), false).is_err());
}

#[test]
fn no_heap_of_pieces_makes_it_fail() {
    let pieces = [
        r"\frac",
        r"\sqrt",
        "{",
        "}",
        "^",
        "_",
        "x",
        "&",
        r"\\",
        r"\left(",
        r"\right)",
        r"\begin{matrix}",
        r"\text",
        "é",
        "−",
        "%",
        "#",
    ];
    let mut state = 1_u32;
    for _ in 0..400 {
        let mut latex = String::new();
        for _ in 0..12 {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            latex.push_str(pieces[(state >> 16) as usize % pieces.len()]);
        }
        let at = Formula::typeset(&latex, false).err().and_then(|error| error.at);
        assert!(at.is_none_or(|at| latex.is_char_boundary(at)), "{latex}");
    }
}

#[test]
fn a_formula_in_words_is_what_a_person_would_say() {
    let said = [
        ("d(t) = (S + ct)^2", "d of t equals (S plus c t) squared"),
        (
            r"t = \frac{-B - \sqrt{B^2 - 4AC}}{2A}",
            "t equals (minus B minus the square root of (B squared minus 4 A C)) over (2 A)",
        ),
        (r"\sin\theta_1 = 1.5^2", "sine of theta sub 1 equals 1.5 squared"),
        (r"\lVert \mathbf{d} \rVert \le 1", "the norm of (d) is at most 1"),
        (r"\begin{pmatrix} 1 \\ -0.5 \end{pmatrix}", "the vector (1, minus 0.5)"),
        (r"\begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix}", "the matrix with rows 1, 2; 3, 4"),
        (r"(S_1 \cup S_2) \setminus C", "(S sub 1 union S sub 2) without C"),
        (r"\sum_{i=0}^{n} x_i", "the sum from i equals 0 to n of x sub i"),
        (r"\text{outside if } t > 0", "outside if t is greater than 0"),
        (r"\mathbf{n} \times \mathbf{P}_v", "n cross P sub v"),
        (r"\mathrm{noise}(2^i P)", "noise (2 to the power of i P)"),
        (r"\{ t \mid t > 0 \}", "{t such that t is greater than 0}"),
        ("a(b + c)", "a (b plus c)"),
        (r"30^\circ", "30 degrees"),
        (r"\frac12", "1 over 2"),
    ];
    for (latex, words) in said {
        assert_eq!(in_words(latex), words, "{latex}");
    }
    assert_eq!(in_words(r"\fraq"), r"\fraq");
}

#[test]
fn an_svg_stands_on_the_baseline_of_its_text_and_is_told_in_words() {
    let formula = set(r"\frac{y}{2} < 1");
    let text = formula.svg();
    let depth = format!("vertical-align:-{:.4}", formula.depth);
    assert!(text.contains(depth.trim_end_matches('0')), "{text}");
    assert!(text.contains("role=\"img\" aria-label=\"y over 2 is less than 1\""), "{text}");
    assert!(text.contains("fill=\"currentColor\"") && text.ends_with("</svg>") && !text.contains("http"));
    assert_eq!(text.matches("<path").count(), 5, "two letters and a rule, a sign and a number: {text}");
}

#[test]
fn formulas_of_a_page_share_their_letters() {
    let mut letters = SharedLetters::default();
    let text: String = ["x + x", "x^2"].iter().map(|latex| set(latex).svg_sharing(&mut letters)).collect();
    assert_eq!(text.matches("<use").count(), 5);
    assert_eq!(letters.definitions().matches("<path").count(), 3, "x, + and 2");
    assert_eq!(SharedLetters::default().definitions(), "");
}

#[test]
fn pixels_lie_on_a_baseline_of_whole_rows_and_are_multiplied_with_alpha() {
    let pixels = set("y").pixels(40.0, Colour { r: 255, g: 128, b: 0, a: 255 });
    assert_eq!(pixels.rgba.len(), (pixels.width * pixels.height * 4) as usize);
    assert!(pixels.baseline >= 17 && pixels.height > pixels.baseline + 6, "{} of {}", pixels.baseline, pixels.height);
    assert!(pixels.rgba.chunks(4).all(|pixel| pixel[..3].iter().all(|level| *level <= pixel[3])));
    assert!(pixels.rgba.chunks(4).any(|pixel| pixel == [255, 128, 0, 255]));
}

#[test]
fn a_formula_is_marks_of_a_drawing_in_every_kind_of_file() {
    let palette = Theme::Light.palette();
    let mut drawing = Drawing::new([200.0, 80.0], palette.ground);
    for form in set(r"\sqrt{x}").marks([20.0, 50.0], 24.0, palette.ink) {
        drawing.put(form, None);
    }
    assert!(svg(&drawing).contains('Q'));
    let painted = crate::view::paint(&drawing, 1.0);
    assert!(painted.rgba.chunks(4).filter(|pixel| pixel[0] < 100).count() > 40);
    assert!(crate::view::pdf("A root", &[drawing]).starts_with(b"%PDF"));
}
