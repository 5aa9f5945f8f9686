//! Plane-strain stress under a loaded surface.
