//! All studies, which command and Python walk.

/// The values of `$visit::<S>()` for the settings `S` of every study, in a crate that depends on `asperity-calibration`
/// too.
#[macro_export]
macro_rules! every_study {
    ($visit:ident) => {
        [
            $visit::<$crate::sensitivity::SensitivitySettings>(),
            $visit::<$crate::ridges::RidgeSettings>(),
            $visit::<$crate::callout::CallOutSettings>(),
            $visit::<asperity_calibration::evidence::EvidenceSettings>(),
            $visit::<asperity_calibration::oil::TractionSettings>(),
            $visit::<asperity_calibration::oil::OilFitSettings>(),
            $visit::<asperity_calibration::oil::OilPlanSettings>(),
            $visit::<asperity_calibration::oil::StribeckSettings>(),
        ]
    };
}

/// Descriptions of all studies for Python: the studies of [`every_study!`](crate::every_study), described by `$visit`, and
/// the studies that command and Python run each in its own way.
#[macro_export]
macro_rules! every_description {
    ($visit:ident) => {
        $crate::every_study!($visit).into_iter().chain([
            asperity_calibration::CalibrationSettings::study(),
            asperity_calibration::DesignSettings::study(),
            $crate::map::MapSettings::study(),
            $crate::compare::CompareSettings::study(),
        ])
    };
}
