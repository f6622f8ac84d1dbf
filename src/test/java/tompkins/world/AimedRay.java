package tompkins.world;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.golden.GoldenRow;
import tompkins.math.Vectors;
import tompkins.ray.Ray;
import tompkins.sceneobject.Plane;
import tompkins.spacetime.Event;
import tompkins.surface.ColouredSurface;

/** A ray of the camera to where the reference data say that a point in motion is seen, or is. */
final class AimedRay {

    final FoundHit hit;

    /**
     * A ray.
     *
     * @param point the point in its rest frame
     * @param camera where and when the ray starts, in the camera frame
     * @param towards where it goes, of any length
     * @param measures whether the point is measured instead of seen
     */
    AimedRay(
            Vector3d beta,
            Vector3d velocity,
            Vector3d place,
            double clockOffset,
            Vector3d point,
            Event camera,
            Vector3dc towards,
            boolean measures) {
        // the screen through the point faces the ray
        Vector3d normal = row(beta, velocity, place, 0, point, new Vector3d(0, 0, 1), camera)
                .ownDirection(camera, Vectors.unit(towards), measures);
        MovingRow row = row(beta, velocity, place, clockOffset, point, normal, camera).row;
        hit = row.find(row.inScene(camera, Vectors.unit(towards), measures));
    }

    private record Scene(MovingRow row) {
        Vector3d ownDirection(Event camera, Vector3d towards, boolean measures) {
            int frame = row.world.frames().size() - 1;
            Ray ray = row.routes.transform(row.inScene(camera, towards, measures), frame, Ray.blank());
            return new Vector3d(ray.dx, ray.dy, ray.dz);
        }
    }

    private static Scene row(
            Vector3d beta,
            Vector3d velocity,
            Vector3d place,
            double offset,
            Vector3d point,
            Vector3d normal,
            Event camera) {
        return new Scene(MovingRow.of(
                List.of(MovingRow.moving(
                        velocity, place, offset, new Plane("", point, normal, ColouredSurface.DEFAULT))),
                beta,
                camera,
                false));
    }

    /** The point of a row of m4 that is seen from the origin. */
    static AimedRay atPoint(GoldenRow row) {
        return new AimedRay(
                new Vector3d(),
                row.vector("v_"),
                row.vector("r0_"),
                0,
                new Vector3d(),
                new Event(0, 0, 0, row.number("T")),
                row.vector("place_"),
                false);
    }

    /** The clock of a row of m4. */
    static AimedRay atClock(GoldenRow row) {
        Vector3d o = row.vector("o_");
        return new AimedRay(
                row.vector("beta_"),
                row.vector("v_"),
                row.vector("p_"),
                row.number("tau0"),
                row.vector("q_"),
                new Event(o.x, o.y, o.z, row.number("T")),
                row.vector("dir_"),
                false);
    }

    /** An end of a rod of m7 that is measured. */
    static AimedRay atEnd(GoldenRow row, int end) {
        return new AimedRay(
                row.vector("beta_"),
                row.vector("v_"),
                row.vector("p_"),
                0,
                row.vector("q" + end + "_"),
                new Event(0, 0, 0, row.number("T")),
                row.vector("end" + end + "_"),
                true);
    }
}
