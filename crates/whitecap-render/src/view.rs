//! One view of the water: where from, which way, through which lens.

use glam::{DVec2, DVec3, Mat4, Quat, Vec3, Vec4, camera::rh};
use whitecap_scene::Camera;

/// The camera's nearest drawn distance in [`View::of_camera`], metres.
const NEAR_M: f32 = 0.1;

/// A view in the host's own terms.
///
/// The eye is f64 and everything else is relative to it, so a sea 1,000 km from the origin is drawn as
/// steadily as one at the origin. Any projection to wgpu's clip space (depth 0 to 1, reversed or not)
/// will do, as long as it agrees with the [`crate::TargetFormat`] that the water was made for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The eye in the world, metres (x east, y up, z south).
    pub eye_m: DVec3,
    /// Rotation from the world's axes to the view's (x right, y up, looking along −z).
    pub view_from_world: Quat,
    /// The projection.
    pub clip_from_view: Mat4,
    /// The target's size in pixels. It sets how finely detail is filtered.
    pub size_px: [u32; 2],
}

impl View {
    /// A view of a scene's camera, with a reversed depth that reaches to infinity
    /// ([`crate::TargetFormat::default`] expects this).
    pub fn of_camera(camera: &Camera, size_px: [u32; 2]) -> View {
        let eye_m = DVec3::from(camera.position_m);
        let forward = (DVec3::from(camera.look_at_m) - eye_m).normalize().as_vec3();
        // Straight up or down, north is the top of the picture.
        let up = if forward.y.abs() > 0.999_99 { Vec3::NEG_Z * forward.y.signum() * -1.0 } else { Vec3::Y };
        let aspect = size_px[0] as f32 / size_px[1] as f32;
        View {
            eye_m,
            view_from_world: rh::view::look_to_quat(forward, up),
            clip_from_view: rh::proj::directx::perspective_infinite_reverse(
                camera.vertical_fov_deg.to_radians() as f32,
                aspect,
                NEAR_M,
            ),
            size_px,
        }
    }

    /// Clip space from the world's axes centred on the eye.
    pub fn clip_from_eye_world(&self) -> Mat4 {
        self.clip_from_view * Mat4::from_quat(self.view_from_world)
    }

    /// The same view through pixels that lie `offset_px` (right, down) from this one's: what it shows in a pixel's middle
    /// lies there in this one.
    pub fn shifted(&self, offset_px: DVec2) -> View {
        let [x, y] = [0, 1].map(|axis| 2.0 * offset_px[axis] / f64::from(self.size_px[axis].max(1)));
        let shift = Vec4::new(-x as f32, y as f32, 0.0, 1.0);
        let clip_from_clip = Mat4::from_cols(Vec4::X, Vec4::Y, Vec4::Z, shift);
        View { clip_from_view: clip_from_clip * self.clip_from_view, ..*self }
    }

    /// The angle that a pixel in the middle of the picture spans, radians.
    pub fn pixel_angle_rad(&self) -> f32 {
        let height = self.size_px[1].max(1) as f32;
        2.0 / (self.clip_from_view.y_axis.y.abs().max(1e-6) * height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec4Swizzles;

    fn camera(look_at_m: [f64; 3]) -> Camera {
        Camera { position_m: [10.0, 4.0, -3.0], look_at_m, vertical_fov_deg: 45.0 }
    }

    #[test]
    fn what_is_looked_at_is_in_the_middle() {
        for target in [[100.0, 0.0, 50.0], [10.0, -96.0, -3.0], [10.0, 104.0, -3.0], [10.0, 4.0, 90.0]] {
            let view = View::of_camera(&camera(target), [320, 180]);
            let toward = (DVec3::from(target) - view.eye_m).as_vec3();
            let clip = view.clip_from_eye_world() * toward.extend(1.0);
            assert!(clip.w > 0.0, "{target:?} is behind the camera");
            assert!((clip.xy() / clip.w).length() < 1e-4, "{target:?} is at {:?}", clip.xy() / clip.w);
        }
    }

    #[test]
    fn up_is_up_and_east_is_right_of_north() {
        let view = View::of_camera(&camera([10.0, 4.0, -100.0]), [320, 180]);
        let clip = |v: Vec3| {
            let c = view.clip_from_eye_world() * v.extend(1.0);
            c.xy() / c.w
        };
        assert!(clip(Vec3::new(0.0, 1.0, -10.0)).y > 0.0);
        assert!(clip(Vec3::new(1.0, 0.0, -10.0)).x > 0.0);
    }

    #[test]
    fn a_shifted_view_shows_what_lies_that_many_pixels_away() {
        let view = View::of_camera(&camera([100.0, 0.0, 50.0]), [320, 180]);
        let offset_px = DVec2::new(0.3, -1.2);
        let shifted = view.shifted(offset_px);
        assert_eq!(shifted.pixel_angle_rad(), view.pixel_angle_rad());
        for toward in [Vec3::new(90.0, -4.0, 53.0), Vec3::new(5.0, -1.0, 3.0), Vec3::new(4e5, 2e3, 2e5)] {
            let pixel = |view: &View| {
                let clip = (view.clip_from_eye_world() * toward.extend(1.0)).as_dvec4();
                DVec2::new(160.0 * (1.0 + clip.x / clip.w), 90.0 * (1.0 - clip.y / clip.w))
            };
            let moved = pixel(&view) - pixel(&shifted);
            assert!((moved - offset_px).length() < 1e-3, "{toward}: {moved}");
        }
    }

    #[test]
    fn a_pixel_spans_its_share_of_the_field_of_view() {
        let view = View::of_camera(&camera([0.0; 3]), [320, 180]);
        let expected = 2.0 * (22.5_f32.to_radians()).tan() / 180.0;
        assert!((view.pixel_angle_rad() - expected).abs() < 1e-6);
    }
}
