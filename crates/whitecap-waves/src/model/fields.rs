//! The samples of a tile at one moment.
//!
//! | symbol | field | unit |
//! | --- | --- | --- |
//! | h | height | m |
//! | dx, dz | horizontal displacement | m |
//! | sx, sz | ∂h/∂x, ∂h/∂z | |
//! | gxx, gxz, gzz | ∂dx/∂x, ∂dx/∂z = ∂dz/∂x, ∂dz/∂z | |
//! | J | (1 + gxx)(1 + gzz) − gxz² | |

/// All fields of a tile as a structure of arrays.
///
/// Index `i = iz * n + ix` is the sample at the rest point (ix L/n, iz L/n) of a tile of side L. Displacement
/// and gradients include the model's choppiness. Every array always holds n² numbers.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TileFields {
    resolution: usize,
    /// Height above the calm sea in metres.
    pub height: Vec<f32>,
    /// Horizontal displacement to the east in metres.
    pub displacement_x: Vec<f32>,
    /// Horizontal displacement to the south in metres.
    pub displacement_z: Vec<f32>,
    /// Derivative of the height by the rest coordinate x.
    pub slope_x: Vec<f32>,
    /// Derivative of the height by the rest coordinate z.
    pub slope_z: Vec<f32>,
    /// Derivative of `displacement_x` by x.
    pub gradient_xx: Vec<f32>,
    /// Derivative of `displacement_x` by z, and equally of `displacement_z` by x: the displacement is a
    /// gradient field.
    pub gradient_xz: Vec<f32>,
    /// Derivative of `displacement_z` by z.
    pub gradient_zz: Vec<f32>,
}

impl TileFields {
    /// The fields of a calm tile with `n` samples a side.
    pub fn new(n: usize) -> Self {
        let mut fields = Self::default();
        fields.resize(n);
        fields
    }

    /// Samples along a side.
    pub fn resolution(&self) -> usize {
        self.resolution
    }

    /// Makes room for `n` samples a side. Does nothing, and allocates nothing, when it has them already;
    /// what the arrays hold after a change of size is unspecified.
    pub fn resize(&mut self, n: usize) {
        self.resolution = n;
        for field in self.arrays_mut() {
            field.resize(n * n, 0.0);
        }
    }

    /// The displacement of sample `i` as (x, height, z) in metres.
    pub fn displacement(&self, i: usize) -> [f32; 3] {
        [self.displacement_x[i], self.height[i], self.displacement_z[i]]
    }

    /// The unit normal of the displaced surface at sample `i`, as (x, y, z).
    ///
    /// The cross product of the tangents T_z × T_x, where T_x = (1 + gxx, sx, gxz) and
    /// T_z = (gxz, sz, 1 + gzz) are the derivatives of the displaced position. It is
    /// (gxz sz − (1 + gzz) sx, J, gxz sx − (1 + gxx) sz) before normalising: y is below 0 where the surface
    /// folds over itself. (0, 1, 0) where the tangents are parallel.
    pub fn normal(&self, i: usize) -> [f32; 3] {
        let (sx, sz) = (self.slope_x[i], self.slope_z[i]);
        let (jxx, jxz, jzz) = (1.0 + self.gradient_xx[i], self.gradient_xz[i], 1.0 + self.gradient_zz[i]);
        let (x, y, z) = (jxz * sz - jzz * sx, jxx * jzz - jxz * jxz, jxz * sx - jxx * sz);
        let length = (x * x + y * y + z * z).sqrt();
        if length > 0.0 { [x / length, y / length, z / length] } else { [0.0, 1.0, 0.0] }
    }

    /// J at sample `i`: the area of the displaced surface, seen from above, per area at rest.
    pub fn jacobian(&self, i: usize) -> f32 {
        let gxz = self.gradient_xz[i];
        (1.0 + self.gradient_xx[i]) * (1.0 + self.gradient_zz[i]) - gxz * gxz
    }

    /// The eigenvalues of the Jacobian matrix at sample `i`, the lesser first: by how much the surface is drawn together
    /// or apart along its two principal directions. ½(Jxx + Jzz) ∓ √(¼(Jxx − Jzz)² + gxz²); the lesser is below 0 where
    /// the surface folds, and says along which line whitecaps break. Their product is J.
    pub fn jacobian_eigenvalues(&self, i: usize) -> [f32; 2] {
        let (jxx, jxz, jzz) = (1.0 + self.gradient_xx[i], self.gradient_xz[i], 1.0 + self.gradient_zz[i]);
        let (mean, half) = (0.5 * (jxx + jzz), 0.5 * (jxx - jzz));
        let apart = half.hypot(jxz);
        [mean - apart, mean + apart]
    }

    fn arrays_mut(&mut self) -> [&mut Vec<f32>; 8] {
        [
            &mut self.height,
            &mut self.displacement_x,
            &mut self.displacement_z,
            &mut self.slope_x,
            &mut self.slope_z,
            &mut self.gradient_xx,
            &mut self.gradient_xz,
            &mut self.gradient_zz,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_tile_is_calm() {
        let fields = TileFields::new(4);
        assert_eq!(fields.resolution(), 4);
        assert_eq!(fields.height.len(), 16);
        assert_eq!(fields.displacement(7), [0.0; 3]);
        assert_eq!(fields.normal(7), [0.0, 1.0, 0.0]);
        assert_eq!(fields.jacobian(7), 1.0);
    }

    #[test]
    fn resizing_keeps_all_arrays_together_and_reuses_them() {
        let mut fields = TileFields::new(8);
        let before = fields.gradient_zz.as_ptr();
        fields.resize(8);
        assert_eq!(fields.gradient_zz.as_ptr(), before);
        fields.resize(16);
        assert!(fields.arrays_mut().iter().all(|field| field.len() == 256));
    }

    /// Against the cross product of the tangents, written out by glam.
    #[test]
    fn the_normal_is_the_cross_product_of_the_tangents() {
        let mut fields = TileFields::new(1);
        (fields.slope_x[0], fields.slope_z[0]) = (0.3, -0.2);
        (fields.gradient_xx[0], fields.gradient_xz[0], fields.gradient_zz[0]) = (-0.4, 0.15, 0.25);
        let tangent_x = glam::Vec3::new(0.6, 0.3, 0.15);
        let tangent_z = glam::Vec3::new(0.15, -0.2, 1.25);
        let normal = tangent_z.cross(tangent_x);
        assert!(glam::Vec3::from(fields.normal(0)).distance(normal.normalize()) < 1e-6);
        assert!((fields.jacobian(0) - normal.y).abs() < 1e-6);
    }

    /// Of a matrix turned by 30°: its eigenvalues are those it was made from.
    #[test]
    fn eigenvalues_are_those_along_the_principal_directions() {
        let mut fields = TileFields::new(1);
        let (sin, cos) = 30.0_f32.to_radians().sin_cos();
        let (least, most) = (-0.2, 1.3);
        fields.gradient_xx[0] = least * cos * cos + most * sin * sin - 1.0;
        fields.gradient_zz[0] = least * sin * sin + most * cos * cos - 1.0;
        fields.gradient_xz[0] = (least - most) * sin * cos;
        let found = fields.jacobian_eigenvalues(0);
        assert!((found[0] - least).abs() < 1e-6 && (found[1] - most).abs() < 1e-6, "{found:?}");
        assert!((found[0] * found[1] - fields.jacobian(0)).abs() < 1e-6);
    }

    #[test]
    fn a_degenerate_point_still_has_a_unit_normal() {
        let mut fields = TileFields::new(1);
        (fields.gradient_xx[0], fields.gradient_zz[0]) = (-1.0, -1.0);
        assert_eq!(fields.normal(0), [0.0, 1.0, 0.0]);
    }
}
