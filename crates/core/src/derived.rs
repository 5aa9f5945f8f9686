//! Values that follow from inputs, stored with them.

/// A value with the inputs that it follows from: it is taken for equal inputs, and made again for others. The inputs are the
/// struct that the function which makes the value takes, so no input can be missing from the comparison.
///
/// ```
/// use asperity_core::derived::Derived;
/// let half = |whole: &u32| (whole % 2 == 0).then_some(whole / 2).ok_or("odd");
/// let first = Derived::renewed(None, 4, half).unwrap();
/// let same = Derived::renewed(Some(&first), 4, |_| Err("made again")).unwrap();
/// assert_eq!(same.value(), &2);
/// assert!(Derived::renewed(Some(&first), 5, half).is_err());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Derived<I, T> {
    inputs: I,
    value: T,
}

impl<I: PartialEq, T: Clone> Derived<I, T> {
    /// The value of `inputs`: the known one if it follows from equal inputs, or else a new one by `make`.
    ///
    /// # Errors
    /// The errors of `make`.
    pub fn renewed<E>(
        known: Option<&Self>,
        inputs: I,
        make: impl FnOnce(&I) -> Result<T, E>,
    ) -> Result<Self, E> {
        let value = match known {
            Some(known) if known.inputs == inputs => known.value.clone(),
            _ => make(&inputs)?,
        };
        Ok(Self { inputs, value })
    }
}

impl<I, T> Derived<I, T> {
    /// The value changed by `change`, still under its inputs.
    #[must_use]
    pub fn with(self, change: impl FnOnce(T) -> T) -> Self {
        Self {
            inputs: self.inputs,
            value: change(self.value),
        }
    }

    /// The value.
    pub fn value(&self) -> &T {
        &self.value
    }
}
