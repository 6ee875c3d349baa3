//! The light reflected at a shading point.

use crate::shading::scene::{Light, Material};
use crate::units::fragment::Fragment;
use glam::DVec3;

/// Colour from light and texture, saturated.
pub(super) fn colour(diffuse: f64, specular: f64, texel: [f32; 3]) -> [f64; 3] {
    let (diffuse, specular) = (diffuse.min(1.0), specular.min(1.0));
    texel.map(|texel| (diffuse * f64::from(texel) + specular).min(1.0))
}

/// Diffuse and specular light for a perturbed normal, without ambient light.
pub(super) fn reflected(
    point: &Fragment,
    normal: DVec3,
    light: &Light,
    material: &Material,
) -> (f64, f64) {
    let diffuse = light.intensity * material.diffuse * normal.dot(point.light).max(0.0);
    let across = normal.dot(point.half);
    let exponent = i32::try_from(material.exponent).unwrap_or(i32::MAX);
    let power = if across > 0.0 { across.min(1.0).powi(exponent) } else { 0.0 };
    (diffuse, light.intensity * material.specular * power)
}
