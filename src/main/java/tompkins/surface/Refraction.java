package tompkins.surface;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Snell's law and Fresnel's equations at a boundary between two transparent media, without polarisation. */
public final class Refraction {

    private Refraction() {}

    /**
     * The unit direction behind the boundary, or the mirrored direction where no light passes (total internal
     * reflection).
     *
     * <p>With the ratio eta of the indices and the cosines c (before) and c' (behind), the direction is {@code eta d +
     * (eta c - c') n} with n against d. The bracket cancels where the indices are nearly equal; it is evaluated as
     * {@code (eta - 1)(eta + 1)/(eta c + c')}.
     *
     * @param d unit direction of the ray
     * @param normal unit normal, on either side
     * @param before refractive index of the medium in which the ray comes
     * @param behind refractive index on the other side
     * @param result receives the direction; may be d itself
     * @return the cosine between the new direction and the normal behind the boundary, or 0 if all light is reflected
     */
    public static double bend(Vector3dc d, Vector3dc normal, double before, double behind, Vector3d result) {
        double along = d.dot(normal);
        double side = along > 0 ? -1 : 1;
        double cosine = Math.abs(along);
        double eta = before / behind;
        double excess = (before - behind) / behind * (eta + 1);
        double squaredCosine = 1 - eta * eta * (1 - cosine) * (1 + cosine);
        if (!(squaredCosine > 0)) {
            result.set(normal).mul(-2 * along).add(d).normalize();
            return 0;
        }
        double cosineBehind = Math.sqrt(squaredCosine);
        double bracket = excess / (eta * cosine + cosineBehind);
        double nx = normal.x() * side * bracket;
        double ny = normal.y() * side * bracket;
        double nz = normal.z() * side * bracket;
        result.set(d).mul(eta).add(nx, ny, nz).normalize();
        return cosineBehind;
    }

    /**
     * The fraction of unpolarised light that is reflected (Fresnel): the mean over both polarisations.
     *
     * @param before refractive index on the side of the ray
     * @param behind refractive index on the other side
     * @param cosine cosine of the angle of incidence, from 0 to 1
     * @param cosineBehind cosine of the angle of refraction, from 0 to 1; 0 where all light is reflected
     */
    public static double reflectance(double before, double behind, double cosine, double cosineBehind) {
        if (cosineBehind == 0) {
            return 1;
        }
        double across = (before * cosine - behind * cosineBehind) / (before * cosine + behind * cosineBehind);
        double along = (behind * cosine - before * cosineBehind) / (behind * cosine + before * cosineBehind);
        return (across * across + along * along) / 2;
    }
}
