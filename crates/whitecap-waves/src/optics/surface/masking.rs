//! How waves hide one another.

/// E[max(x, 0)] for a Gaussian x of mean −z and variance 1, z ≥ 0: what facets show that lean against their
/// mean. Exactly φ(z) − z (1 − Φ(z)).
///
/// A slope's projection has mean c and deviation τ; what a ray meets of it is E[max(v, 0)] = c + τ k(c/τ) for
/// c ≥ 0, k this function. Smith's Λ = k(z)/z is Bruneton's (exp(−a²) − a√π erfc a)/(2a√π) with a = z/√2.
///
/// φ over a cubic, fitted to the exact function: off by 3e-5 at most, and no erfc.
pub fn hidden_projection(z: f64) -> f64 {
    libm::exp(-0.5 * z * z) / (2.506_63 + z * (3.136_36 + z * (1.464_99 + z * 0.169_39)))
}

/// The share of the light on its way along a ray that waves let pass, of what is seen by an eye that itself sees
/// the share `seen_share` (Smith's G₁ = 1/(1 + Λ)) of the facets turned to it. `mean` and `deviation` are c and
/// τ of the ray's direction.
///
/// With heights correlated both ways, (1 + Λv)/(1 + Λv + Λl) (Ross, Dion and Potvin 2005), which is
/// 1/(1 + G₁ Λl). An eye at the water's level sees the tops alone, and from there any ray gets away.
pub fn shown_share(mean: f64, deviation: f64, seen_share: f64) -> f64 {
    if mean <= 0.0 {
        return 0.0;
    }
    let deviation = deviation.max(1e-6);
    mean / (mean + seen_share * deviation * hidden_projection(mean / deviation))
}
