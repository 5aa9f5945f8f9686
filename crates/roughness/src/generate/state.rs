//! State of a flank between the measured stages of a test.

use asperity_core::{DomainError, number};

/// Place of a flank between two measured stages of a test that follow each other. Stage 0 is before the test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Number of stages after the start of the test.
    pub(super) stages: usize,
    /// The stage before the flank.
    pub(super) stage: usize,
    /// Part of the way to the next stage.
    pub(super) part: f64,
    engagements: Option<f64>,
}

impl State {
    /// A part of the way from before a test, 0, to its only stage, 1.
    ///
    /// # Errors
    /// When the part is not from 0 to 1.
    pub fn of_one_stage(part: f64) -> Result<Self, DomainError> {
        let rule = "must be from 0 to 1";
        DomainError::require((0.0..=1.0).contains(&part), "state", part, "-", rule)?;
        Ok(Self {
            stages: 1,
            stage: 0,
            part,
            engagements: None,
        })
    }

    /// After a number of `engagements` of a tooth, of `stages` measured after these numbers, which rise.
    ///
    /// # Errors
    /// When no stage is given, the stages do not rise from above 0, or the engagements are not from 0 to the last of them.
    ///
    /// ```
    /// use asperity_roughness::generate::State;
    /// assert_eq!(State::after(2e5, &[1e4, 1e6])?.to_string(), "after 200000 engagements");
    /// assert!(State::after(2e6, &[1e4, 1e6]).is_err());
    /// # Ok::<(), asperity_core::DomainError>(())
    /// ```
    pub fn after(engagements: f64, stages: &[f64]) -> Result<Self, DomainError> {
        let mut before = 0.0;
        for stage in stages {
            let rule = "must be finite and rise from stage to stage, from above 0";
            let rises = stage.is_finite() && *stage > before;
            DomainError::require(rises, "engagements of a stage", *stage, "-", rule)?;
            before = *stage;
        }
        let rule = "must be from 0 to the engagements of the last stage";
        let is_within = (0.0..=before).contains(&engagements) && !stages.is_empty();
        DomainError::require(is_within, "engagements", engagements, "-", rule)?;
        let stage = stages[..stages.len() - 1]
            .iter()
            .filter(|stage| **stage <= engagements)
            .count();
        let from = match stage {
            0 => 0.0,
            _ => stages[stage - 1],
        };
        Ok(Self {
            stages: stages.len(),
            stage,
            part: (engagements - from) / (stages[stage] - from),
            engagements: Some(engagements),
        })
    }

    /// A part of the way to the only stage, by default its end; or, of several stages, after `engagements`, by default at the last.
    ///
    /// # Errors
    /// As [`of_one_stage`](Self::of_one_stage) and [`after`](Self::after).
    pub fn stated(
        part: Option<f64>,
        engagements: Option<f64>,
        stages: &[f64],
    ) -> Result<Self, DomainError> {
        match stages.last() {
            None => Self::of_one_stage(part.unwrap_or(1.0)),
            Some(last) => Self::after(engagements.unwrap_or(*last), stages),
        }
    }

    /// Engagements until the flank, if the stages have them.
    #[must_use]
    pub fn engagements(&self) -> Option<f64> {
        self.engagements
    }

    /// Part of the way to the only stage, unless it has engagements.
    #[must_use]
    pub fn part(&self) -> Option<f64> {
        self.engagements.is_none().then_some(self.part)
    }

    /// Number of measured stages after the start of the test.
    #[must_use]
    pub fn stages(&self) -> usize {
        self.stages
    }

    /// Weights of the heights that were lost until each stage.
    pub(super) fn weights(self) -> Vec<f64> {
        let mut weights = vec![0.0; self.stages];
        weights[self.stage] = self.part;
        if self.stage > 0 {
            weights[self.stage - 1] = 1.0 - self.part;
        }
        weights
    }
}

/// A state in words, by its part of the way or its engagements.
#[must_use]
pub fn state_words(part: Option<f64>, engagements: Option<f64>) -> Option<String> {
    match (part, engagements) {
        (_, Some(engagements)) => Some(format!("after {} engagements", number(engagements))),
        (Some(part), None) => Some(format!("in state {part} from before to after a test")),
        (None, None) => None,
    }
}

impl std::fmt::Display for State {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&state_words(self.part(), self.engagements).unwrap_or_default())
    }
}
