package tompkins.shutter;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * What a shutter knows of a ray at the lens, in the camera frame: where it crosses the lens, and the point I in which
 * the lens focuses it. I is given by the direction of the chief ray (from the centre of the lens, traced outwards) and
 * the inverse of its signed distance, which is positive for I in front of the camera, negative for I behind it, and 0
 * at infinity. In this form no case needs a branch: the traced ray leaves the lens at the point E in the direction
 * {@code D = m - w r}, with {@code r = E - centre}, whether I is near, far, at infinity or behind.
 *
 * @param centre centre of the lens
 * @param pupilPoint the point E at which the ray crosses the lens
 * @param chiefDirection unit vector m
 * @param inverseFocusDistance w, in inverse lengths
 * @param viewDirection unit vector along the axis of the lens
 */
public record LensRay(
        Vector3dc centre,
        Vector3dc pupilPoint,
        Vector3dc chiefDirection,
        double inverseFocusDistance,
        Vector3dc viewDirection) {

    /** r: from the centre of the lens to the pupil point. */
    public Vector3d offset() {
        return pupilPoint.sub(centre, new Vector3d());
    }

    /** D = m - w r: along the traced ray, as long as the ratio of the distances of I from E and from the centre. */
    public Vector3d towardsFocus() {
        return new Vector3d(chiefDirection).sub(offset().mul(inverseFocusDistance));
    }

    /** The point I; not finite if the focus is at infinity. */
    public Vector3d focusPoint() {
        return new Vector3d(chiefDirection).div(inverseFocusDistance).add(centre);
    }

    /** The signed distance from E to I: positive in front, negative behind; infinite at infinity. */
    public double focusDistance() {
        return towardsFocus().length() / inverseFocusDistance;
    }

    /**
     * Distance from the centre of the lens to the detector point, for a detector at the given distance behind the lens.
     */
    public double detectorPointDistance(double detectorDistance) {
        return detectorDistance / chiefDirection.dot(viewDirection);
    }
}
