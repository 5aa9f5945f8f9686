//! All studies, which command and Python walk.

/// The values of `$visit::<S>()` for the settings `S` of every study, in a crate that depends on `asperity-calibration`
/// too.
#[macro_export]
macro_rules! every_study {
    ($visit:ident) => {
        [
            $visit::<$crate::compare::CompareSettings>(),
            $visit::<$crate::map::MapSettings>(),
            $visit::<$crate::cycle::CycleSettings>(),
            $visit::<$crate::sensitivity::SensitivitySettings>(),
            $visit::<$crate::ridges::RidgeSettings>(),
            $visit::<$crate::callout::CallOutSettings>(),
            $visit::<$crate::change::ChangeSettings>(),
            $visit::<$crate::running_in::RunningInSettings>(),
            $visit::<asperity_calibration::evidence::EvidenceSettings>(),
            $visit::<asperity_calibration::CalibrationSettings>(),
            $visit::<asperity_calibration::DesignSettings>(),
            $visit::<asperity_calibration::oil::TractionSettings>(),
            $visit::<asperity_calibration::oil::OilFitSettings>(),
            $visit::<asperity_calibration::oil::OilPlanSettings>(),
            $visit::<asperity_calibration::oil::StribeckSettings>(),
        ]
    };
}
