package tompkins.ray;

import org.joml.Vector3dc;

/**
 * Coordinates (u, v) of a point on a surface, with their gradients in space: moving by a vector d on the surface
 * changes u by {@code gradientU . d}. Each object says what its u and v are; those of infinite planes are lengths,
 * others run from 0 to 1.
 *
 * @param u first coordinate
 * @param v second coordinate
 */
public record SurfaceCoordinates(double u, double v, double uX, double uY, double uZ, double vX, double vY, double vZ) {

    /** Coordinates whose gradients are vectors. */
    public SurfaceCoordinates(double u, double v, Vector3dc gradientU, Vector3dc gradientV) {
        this(u, v, gradientU.x(), gradientU.y(), gradientU.z(), gradientV.x(), gradientV.y(), gradientV.z());
    }

    /** Half the change of u over the spot that the ray lights on the surface (a box of the spot's size). */
    public double spreadU(Ray ray, Hit hit) {
        return spread(ray, hit, uX, uY, uZ);
    }

    /** Half the change of v over the spot that the ray lights on the surface. */
    public double spreadV(Ray ray, Hit hit) {
        return spread(ray, hit, vX, vY, vZ);
    }

    /**
     * The spot is an ellipse: its short axis is the width of the ray, across the plane of incidence; its long axis is
     * that divided by the cosine, along the ray's trace on the surface.
     */
    private static double spread(Ray ray, Hit hit, double gradientX, double gradientY, double gradientZ) {
        double cosine = hit.cosine(ray);
        double gradientAlongNormal = gradientX * hit.normalX + gradientY * hit.normalY + gradientZ * hit.normalZ;
        double squaredGradient = gradientX * gradientX
                + gradientY * gradientY
                + gradientZ * gradientZ
                - gradientAlongNormal * gradientAlongNormal;
        double gradientAlongRay =
                gradientX * ray.dx + gradientY * ray.dy + gradientZ * ray.dz - cosine * gradientAlongNormal;
        // unit trace t = (d - cosine n) / sine; (gradient . t)^2 (1/cosine^2 - 1) + gradient^2, and sine^2 cancels
        double stretched = gradientAlongRay / cosine;
        double half = ray.widthAt(hit.distance) / 2;
        return half * Math.sqrt(Math.max(0, squaredGradient) + stretched * stretched);
    }

    /** The part of {@link #spreadU} along the trace of the ray on the surface, with the sign of the change that way. */
    public double alongU(Ray ray, Hit hit) {
        return along(ray, hit, uX, uY, uZ);
    }

    /** The part of {@link #spreadV} along that trace. */
    public double alongV(Ray ray, Hit hit) {
        return along(ray, hit, vX, vY, vZ);
    }

    private static double along(Ray ray, Hit hit, double gradientX, double gradientY, double gradientZ) {
        double cosine = hit.cosine(ray);
        double x = ray.dx - cosine * hit.normalX;
        double y = ray.dy - cosine * hit.normalY;
        double z = ray.dz - cosine * hit.normalZ;
        double sine = Math.sqrt(x * x + y * y + z * z);
        double trace = sine == 0 ? 0 : (gradientX * x + gradientY * y + gradientZ * z) / sine;
        return ray.widthAt(hit.distance) / 2 * trace / Math.abs(cosine);
    }
}
