// Written by bindings/rust/generate.py from the public headers: do not edit.
#[allow(unused_imports)]
use crate::*;


extern "C" {
    /// Sine; the error is below 0.51 ulp for every argument, however large. Odd to the bit: sin(-x) =
    /// -sin(x), and a zero keeps its sign.
    ///
    /// @param angle  rad; any double
    /// @return the sine, -1 to 1; NaN for an infinite angle
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_sin(angle: f64) -> f64;
    /// Cosine; the error is below 0.51 ulp for every argument, however large. Even to the bit: cos(-x) =
    /// cos(x).
    ///
    /// @param angle  rad; any double
    /// @return the cosine, -1 to 1; NaN for an infinite angle
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_cos(angle: f64) -> f64;
    /// The angle of a point in the plane, from the x axis towards the y axis; the error is below 0.52
    /// ulp. Zeros and infinities are as in C11 Annex F: atan2(+-0, x) is +-0 for x > 0 or +0, and +-pi
    /// for x < 0 or -0; two infinities denote a point on a diagonal.
    ///
    /// @param y  coordinate on the y axis, any unit; any double
    /// @param x  coordinate on the x axis, the same unit; any double
    /// @return the angle, rad, -pi to pi
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_atan2(y: f64, x: f64) -> f64;
    /// Arc cosine; the error is below 0.51 ulp. acos(1) is +0.
    ///
    /// @param cosine  -1 to 1; any other double gives NaN
    /// @return the angle, rad, 0 to pi
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_acos(cosine: f64) -> f64;
}
