package tompkins.camera;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The thin lens by the image of a point on the ray: 1/f = 1/g + 1/b. */
public final class NaiveThinLens {

    private NaiveThinLens() {}

    /** The direction behind the lens, through the image of the point at distance {@code g} before the lens. */
    public static Vector3d bend(Vector3dc d, Vector3dc axis, Vector3dc offset, double power, double g) {
        double focalLength = 1 / power;
        double magnification = focalLength / (g - focalLength);
        double imageDistance = focalLength * g / (g - focalLength);
        double side = d.dot(axis) > 0 ? 1 : -1;
        Vector3d point = new Vector3d(d).mul(-g / Math.abs(d.dot(axis))).add(offset);
        Vector3d height = new Vector3d(point).sub(new Vector3d(axis).mul(point.dot(axis)));
        Vector3d image = height.mul(-magnification).add(new Vector3d(axis).mul(side * imageDistance));
        Vector3d out = image.sub(offset);
        return imageDistance < 0 ? out.negate() : out;
    }
}
