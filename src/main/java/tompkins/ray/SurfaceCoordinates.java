package tompkins.ray;

/**
 * Coordinates (u, v) of a point on a surface, with their gradients in space: moving by a vector d on the surface changes u
 * by {@code gradientU . d}. What u and v are is said by each object; infinite planes use lengths, others run from 0 to 1.
 *
 * @param u first coordinate
 * @param v second coordinate
 */
public record SurfaceCoordinates(double u, double v, double uX, double uY, double uZ, double vX, double vY, double vZ) {

    /** How u changes from the middle of the spot that the ray lights on the surface to its far end, along the ray's trace. */
    public double alongU(Ray ray, Hit hit) {
        return along(ray, hit, uX, uY, uZ);
    }

    /** How v changes from the middle of that spot to its far end. */
    public double alongV(Ray ray, Hit hit) {
        return along(ray, hit, vX, vY, vZ);
    }

    /** How much u changes from the middle of that spot to its side, across the ray's trace; 0 or above. */
    public double acrossU(Ray ray, Hit hit) {
        return across(ray, hit, uX, uY, uZ);
    }

    /** How much v changes from the middle of that spot to its side; 0 or above. */
    public double acrossV(Ray ray, Hit hit) {
        return across(ray, hit, vX, vY, vZ);
    }

    /** The spot is as wide as the ray across the plane of incidence, and in it longer by the cosine of incidence. */
    private static double along(Ray ray, Hit hit, double gradientX, double gradientY, double gradientZ) {
        double cosine = hit.cosine(ray);
        double trace = trace(ray, hit, cosine, gradientX, gradientY, gradientZ);
        return ray.widthAt(hit.distance) / 2 * trace / Math.abs(cosine);
    }

    private static double across(Ray ray, Hit hit, double gradientX, double gradientY, double gradientZ) {
        double trace = trace(ray, hit, hit.cosine(ray), gradientX, gradientY, gradientZ);
        double normal = gradientX * hit.normalX + gradientY * hit.normalY + gradientZ * hit.normalZ;
        double squared = gradientX * gradientX + gradientY * gradientY + gradientZ * gradientZ;
        return ray.widthAt(hit.distance) / 2 * Math.sqrt(Math.max(0, squared - normal * normal - trace * trace));
    }

    /** The part of a gradient along the trace of the ray on the surface, a unit vector; 0 if the ray has none. */
    private static double trace(Ray ray, Hit hit, double cosine, double gradientX, double gradientY, double gradientZ) {
        double x = ray.dx - cosine * hit.normalX;
        double y = ray.dy - cosine * hit.normalY;
        double z = ray.dz - cosine * hit.normalZ;
        double sine = Math.sqrt(x * x + y * y + z * z);
        return sine == 0 ? 0 : (gradientX * x + gradientY * y + gradientZ * z) / sine;
    }
}
