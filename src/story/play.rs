//! Stepping by itself, at a chosen speed. Time is handed in, so that nothing here looks at a clock.

/// Steps a second that are offered.
pub const SPEEDS: [f64; 6] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0];

/// The longest time between two frames that counts, in seconds, or as long as one step takes: a window that was hidden does not
/// catch up.
const LONGEST_FRAME: f64 = 0.25;

/// Plays the steps of a story.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Player {
    speed: f64,
    is_playing: bool,
    /// The part of a step that has passed.
    owed: f64,
}

impl Default for Player {
    fn default() -> Self {
        Self { speed: 2.0, is_playing: false, owed: 0.0 }
    }
}

impl Player {
    /// Steps a second.
    #[must_use]
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Whether it plays.
    #[must_use]
    pub fn is_playing(&self) -> bool {
        self.is_playing
    }

    /// Sets the steps a second, within what is offered.
    pub fn set_speed(&mut self, speed: f64) {
        self.speed = speed.clamp(SPEEDS[0], SPEEDS[SPEEDS.len() - 1]);
    }

    /// The next speed up or down the list of those that are offered.
    pub fn change_speed(&mut self, faster: bool) {
        let next = if faster {
            SPEEDS.into_iter().find(|&speed| speed > self.speed)
        } else {
            SPEEDS.into_iter().rev().find(|&speed| speed < self.speed)
        };
        self.speed = next.unwrap_or(self.speed);
    }

    /// Begins to play, or pauses.
    pub fn set_playing(&mut self, is_playing: bool) {
        *self = Self { is_playing, owed: 0.0, ..*self };
    }

    /// Lets time pass; returns how many steps are to be made.
    pub fn advance(&mut self, seconds: f64) -> usize {
        if !self.is_playing {
            return 0;
        }
        self.owed += (seconds.max(0.0) * self.speed).min((LONGEST_FRAME * self.speed).max(1.0));
        let steps = self.owed.floor();
        self.owed -= steps;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most a few, see above")]
        let steps = steps as usize;
        steps
    }

    /// Seconds until the next step.
    #[must_use]
    pub fn wait(&self) -> f64 {
        (1.0 - self.owed) / self.speed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_steps_are_made_as_the_speed_says_however_time_is_cut_up() {
        for frames in [8_u32, 60, 144] {
            let mut player = Player::default();
            player.set_playing(true);
            player.set_speed(5.0);
            let steps: usize = (0..4 * frames).map(|_| player.advance(1.0 / f64::from(frames))).sum();
            assert!(steps.abs_diff(20) <= 1, "{frames} frames a second: {steps}");
        }
    }

    #[test]
    fn a_pause_makes_no_steps_and_forgets_what_was_owed() {
        let mut player = Player::default();
        assert_eq!(player.advance(10.0), 0);
        player.set_playing(true);
        assert_eq!(player.advance(0.24), 0);
        player.set_playing(false);
        player.set_playing(true);
        assert!((player.wait() - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_window_that_was_hidden_for_a_minute_does_not_catch_up() {
        let mut player = Player::default();
        player.set_playing(true);
        player.set_speed(20.0);
        assert_eq!(player.advance(60.0), 5);
        player.set_speed(0.5);
        assert_eq!(player.advance(60.0), 1);
    }

    #[test]
    fn speeds_stay_within_what_is_offered() {
        let mut player = Player::default();
        for _ in 0..10 {
            player.change_speed(true);
        }
        assert_eq!(player.speed(), 20.0);
        player.change_speed(false);
        assert_eq!(player.speed(), 10.0);
        player.set_speed(0.0);
        assert_eq!(player.speed(), 0.5);
    }
}
