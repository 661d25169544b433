//! Questions, answered rightly and in every wrong way that they expect.

use super::Check;
use crate::lesson::model::{Change, Edit, Surface};
use crate::lesson::place::Place;
use crate::lesson::question::{Answer, Form, Posed, PosedEdit, Reckoned, Spot, Verdict};
use crate::lesson::scenes::changed;
use crate::lesson::stage::Stage;
use crate::scene::{EmbeddedFiles, load_with};

/// Answers a question in all ways that it expects.
pub(super) fn check_answers(check: &mut Check, posed: &Posed, stage: &Stage, place: Place) {
    match &posed.form {
        Form::Number(reckoned) | Form::Time(reckoned) => {
            numbers(check, posed, reckoned, |number| Answer::Number(*number), place);
        }
        Form::Intervals(reckoned) => numbers(check, posed, reckoned, |list| Answer::Intervals(list.clone()), place),
        Form::Choice(choices) => {
            let right = choices.iter().filter(|choice| choice.is_right).count();
            if right != 1 {
                let are = if right == 0 { "none is".to_owned() } else { format!("{right} are") };
                check.add(place, format!("exactly one choice is to be right, and {are}{}", aim(stage)));
            }
            for (number, choice) in choices.iter().enumerate() {
                let verdict = posed.judge(&Answer::Choice(number));
                let expected = if choice.is_right { None } else { Some(number) };
                expect(check, &verdict, expected, place, stage);
            }
        }
        Form::Order { right, wrong, .. } => {
            expect(check, &posed.judge(&Answer::Order(right.clone())), None, place, stage);
            for (number, (order, _)) in wrong.iter().enumerate() {
                expect(check, &posed.judge(&Answer::Order(order.clone())), Some(number), place, stage);
            }
        }
        Form::Place(surface, reckoned) => clicks(check, posed, *surface, reckoned, stage, place),
        Form::Edit(edit) => edits(check, posed, edit, stage),
    }
}

fn aim(stage: &Stage) -> String {
    stage.aim.at.map_or(String::new(), |at| format!(" (traced: {at})"))
}

/// A right answer is accepted; a wrong one is refused, with what belongs to it.
fn expect(check: &mut Check, verdict: &Verdict, misconception: Option<usize>, place: Place, stage: &Stage) {
    check.checked.answers += 1;
    let problem = match misconception {
        None if !verdict.is_right => "the right answer is not accepted".to_owned(),
        Some(number) if verdict.is_right => {
            format!("the wrong answer {} is accepted: it is within the tolerance of the right one", number + 1)
        }
        Some(number) if verdict.misconception != Some(number) => {
            format!("what belongs to the wrong answer {} is never said: another answer is taken for it", number + 1)
        }
        _ => return,
    };
    check.add(place, format!("{problem}{}", aim(stage)));
}

fn numbers<T>(check: &mut Check, posed: &Posed, reckoned: &Reckoned<T>, answer: impl Fn(&T) -> Answer, place: Place) {
    let mut judge = |value: &T, misconception: Option<usize>| {
        let verdict = posed.judge(&answer(value));
        check.checked.answers += 1;
        let problem = match misconception {
            None if !verdict.is_right => "the right answer is not accepted: it is no number, or the tolerance is none",
            Some(_) if verdict.is_right => "a wrong answer is accepted: it is within the tolerance of the right one",
            Some(number) if verdict.misconception != Some(number) => {
                "what belongs to a wrong answer is never said: another wrong answer has the same value"
            }
            _ => return,
        };
        let number = misconception.map_or(String::new(), |number| format!(" (wrong answer {})", number + 1));
        check.add(place, format!("{problem}{number}"));
    };
    judge(&reckoned.answer, None);
    for (number, (value, _)) in reckoned.wrong.iter().enumerate() {
        judge(value, Some(number));
    }
}

/// A click in the picture is judged by its pixels; in the side view by points that lie apart in space, because its scale is the window's.
fn clicks(check: &mut Check, posed: &Posed, surface: Surface, reckoned: &Reckoned<Spot>, stage: &Stage, place: Place) {
    let scene = &stage.scene.scene;
    let in_image = |spot: &Spot| match spot {
        Spot::Pixel(pixel) => Some(*pixel),
        Spot::World(point) => scene.camera.project(scene.image, (*point).into()),
    };
    if surface == Surface::Side {
        let is_point = |spot: &Spot| matches!(spot, Spot::World(_));
        if !is_point(&reckoned.answer) || reckoned.wrong.iter().any(|(spot, _)| !is_point(spot)) {
            check.add(place, "in the side view a place is a point in space");
        }
        if reckoned.wrong.iter().any(|(spot, _)| *spot == reckoned.answer) {
            check.add(place, "a wrong place is the right one");
        }
        check.checked.answers += 1;
        return;
    }
    let spots = std::iter::once((None, &reckoned.answer))
        .chain(reckoned.wrong.iter().enumerate().map(|(n, (spot, _))| (Some(n), spot)));
    for (misconception, spot) in spots {
        match in_image(spot) {
            Some(click) => expect(check, &posed.judge_click(click, in_image), misconception, place, stage),
            None => check.add(place, "a place lies behind the eye, so that nobody can click it"),
        }
    }
}

fn edits(check: &mut Check, posed: &Posed, edit: &PosedEdit, stage: &Stage) {
    let Edit { until, solution, wrong } = &edit.edit;
    check.checked.answers += 1 + wrong.len();
    match judged(check, posed, stage, solution) {
        Ok(verdict) if verdict.is_right => {}
        Ok(_) => check.add(until.place, "the solution does not do what `until` asks"),
        Err(problem) => check.add(until.place, format!("the solution: {problem}")),
    }
    for (number, wrong) in wrong.iter().enumerate() {
        let problem = match judged(check, posed, stage, &wrong.change) {
            Ok(verdict) if verdict.is_right => "this wrong change does what `until` asks".to_owned(),
            Ok(verdict) if verdict.misconception == Some(number) => continue,
            Ok(verdict) => match verdict.misconception {
                Some(other) => format!(
                    "what belongs to this wrong change is never said: the `when` of wrong change {} holds of it, too",
                    other + 1
                ),
                None => "what belongs to this wrong change is never said: its `when` does not hold of it".to_owned(),
            },
            Err(problem) => format!("this wrong change: {problem}"),
        };
        check.add(wrong.when.place, problem);
    }
}

fn judged(check: &Check, posed: &Posed, stage: &Stage, changes: &[Change]) -> Result<Verdict, String> {
    let edited = edited(check, stage, changes)?;
    posed.judge_edit(&edited).map_err(|error| error.to_string())
}

fn edited(check: &Check, stage: &Stage, changes: &[Change]) -> Result<Stage, String> {
    let text = changed(&stage.scene.text, changes)?;
    let name = &stage.scene.name;
    let own = check.shelf.text(&check.lesson.id, name).is_some();
    let scene = if own {
        load_with(&text, name, check.shelf.pictures(&check.lesson.id).as_ref())
    } else {
        load_with(&text, name, &EmbeddedFiles::of_scene(name))
    };
    let scene = scene.map_err(|errors| errors.to_string())?;
    let scene = match &stage.aim.accuracy {
        Some(profile) => scene.with_profile(profile),
        None => scene,
    };
    stage.edited(text, scene)
}
