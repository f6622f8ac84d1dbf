package tompkins.camera;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Require;

/** The axes of a camera as unit vectors: right = up x forward, x for one that looks along z with y up. */
record CameraAxes(Vector3dc right, Vector3dc up, Vector3dc forward) {

    /** The axes of a camera that looks along {@code view} with {@code top} as near to up as possible. */
    static CameraAxes of(Vector3dc view, Vector3dc top) {
        Vector3d forward = Vectors.unit(view);
        Vector3d right = Vectors.unit(Vectors.cross(Vectors.unit(top), forward));
        return new CameraAxes(right, forward.cross(right, new Vector3d()), forward);
    }

    /** The rotation that takes other axes to these. */
    Quaterniond turnFrom(CameraAxes before) {
        Matrix3d there = new Matrix3d(right, up, forward);
        Matrix3d back = new Matrix3d(before.right, before.up, before.forward).transpose();
        return new Quaterniond().setFromNormalized(there.mul(back)).normalize();
    }

    /** Accepts a top direction that is not parallel to the view direction. */
    static Vector3dc requireTop(Vector3dc top, Vector3dc view) {
        Vector3dc checked = Require.direction("topDirection", top);
        if (Vectors.cross(Vectors.unit(checked), Vectors.unit(view)).length() < 1e-9) {
            throw new InvalidPropertyException(
                    "topDirection", "not parallel to viewDirection " + Require.text(view), Require.text(checked));
        }
        return checked;
    }
}
