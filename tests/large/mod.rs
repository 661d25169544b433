//! Large recordings, and the workbench's frames timed without a window: layout on one side, shape building on the other.
#![allow(dead_code, reason = "the test and the benchmark use some of it each")]

use egui::{Context, Pos2, RawInput, Rect, Vec2};
use rayscope::app::Workbench;
use rayscope::cpu_time::cpu_time;
use rayscope::folder::Outside;
use rayscope::scene::{embedded_scene, load};
use rayscope::trace::record_pixel;
use std::time::{Duration, Instant};

/// The fishbowl, whose glass and water send two rays wherever one meets them, with so many samples of a pixel that its telling
/// pixel records at least so many events.
pub fn fishbowl_with(events: usize) -> String {
    let text = embedded_scene("optics/fishbowl").expect("the scene is embedded").text;
    // A small picture, as all of its pixels take as many samples.
    let text = text.replace("\"width\": 640, \"height\": 480", "\"width\": 32, \"height\": 24");
    let text = text.replace("\"pixels\": [[330, 232], [300, 200]]", "\"pixels\": [[16, 11]]");
    let limits = "\"limits\":";
    assert!(text.contains(limits), "the scene's limits are written in another way");
    let sampled = (0..12)
        .map(|power| text.replace(limits, &format!("\"sampling\": {{ \"samples\": {} }},\n  {limits}", 1 << power)));
    let is_enough = |text: &String| {
        let scene = load(text, "fishbowl").expect("only a limit was changed");
        record_pixel(&scene, scene.pixels[0][0], scene.pixels[0][1]).events.len() >= events
    };
    sampled.into_iter().find(is_enough).expect("so many samples are enough")
}

/// What one frame took on the thread that shows it, in milliseconds of its own working time.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Everything that the workbench does, and the layout of its texts.
    pub layout: f64,
    /// Turning shapes into triangles for a graphics card.
    pub shapes: f64,
}

impl Frame {
    /// Both.
    pub fn total(&self) -> f64 {
        self.layout + self.shapes
    }
}

/// A workbench without a window, as a screen reader would have it shown.
pub struct Show {
    pub ctx: Context,
    pub workbench: Workbench,
    time: f64,
    size: Vec2,
}

impl Show {
    /// Opens the text of a scene, and waits until its picture and its story are there.
    pub fn open(name: &str, text: &str, size: Vec2) -> Self {
        let ctx = Context::default();
        ctx.enable_accesskit();
        let mut workbench = None;
        let input = RawInput { screen_rect: Some(Rect::from_min_size(Pos2::ZERO, size)), ..RawInput::default() };
        let mut output = ctx.run_ui(input, |ui| {
            workbench.get_or_insert_with(|| Workbench::new(ui.ctx(), name, text, Outside::Refused)).ui(ui);
        });
        // Textures are for a graphics card, which there is none of.
        output.textures_delta.clear();
        let workbench = workbench.expect("it was made in the first frame");
        let mut show = Self { ctx, workbench, time: 0.0, size };
        show.wait();
        show
    }

    /// Shows frames until nothing is being done in the background.
    pub fn wait(&mut self) {
        let begin = Instant::now();
        let mut quiet = 0;
        while quiet < 10 {
            assert!(begin.elapsed() < Duration::from_mins(5), "it never comes to rest");
            self.frame();
            let busy = self.workbench.is_busy() || !self.workbench.picture_finished();
            quiet = if busy { 0 } else { quiet + 1 };
            std::thread::sleep(Duration::from_millis(if busy { 20 } else { 2 }));
        }
    }

    /// Shows one frame.
    pub fn frame(&mut self) -> Frame {
        self.time += 1.0 / 60.0;
        let screen_rect = Some(Rect::from_min_size(Pos2::ZERO, self.size));
        let input = RawInput { screen_rect, time: Some(self.time), ..RawInput::default() };
        let (layout, mut output) = cpu_time(|| self.ctx.run_ui(input, |ui| self.workbench.ui(ui)));
        let (shapes, triangles) = cpu_time(|| self.ctx.tessellate(output.shapes, output.pixels_per_point));
        output.textures_delta.clear();
        assert!(!triangles.is_empty());
        Frame { layout: 1e3 * layout.as_secs_f64(), shapes: 1e3 * shapes.as_secs_f64() }
    }
}

/// Numbers, ascending, to read shares from.
pub struct Spread(Vec<f64>);

impl Spread {
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.into_iter().collect();
        values.sort_by(f64::total_cmp);
        Self(values)
    }

    /// The value that this share of all values does not exceed.
    pub fn at(&self, share: f64) -> f64 {
        let count = self.0.len();
        let place = (0..count).find(|&place| (place + 1) as f64 >= share * count as f64);
        self.0[place.unwrap_or(count - 1)]
    }
}
