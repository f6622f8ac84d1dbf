package tompkins.world;

import java.util.List;
import org.joml.Vector3d;
import tompkins.golden.GoldenRow;
import tompkins.light.Sightline;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.sceneobject.Plane;
import tompkins.spacetime.Event;
import tompkins.surface.ColouredSurface;

/** The way of light from the lamp of a row to a surface that moves, and to a place at rest at the same event. */
final class LampWay {

    final Sightline atSurface = new Sightline();
    final Sightline atRest = new Sightline();
    final Event hit;
    final Event lampFrameEmission;

    LampWay(GoldenRow row) {
        Vector3d place = row.vector("x_");
        hit = new Event(place.x, place.y, place.z, row.number("t"));
        Plane surface = new Plane("", new Vector3d(), row.vector("n_"), ColouredSurface.DEFAULT);
        MovingRow scene = MovingRow.lit(
                List.of(MovingRow.moving(row.vector("vs_"), new Vector3d(), 0, surface)),
                row.vector("vl_"),
                row.vector("p_"),
                row.vector("q_"),
                row.has("law", "galilean"));
        int frame = row.vector("vs_").length() == 0 ? 0 : 1;
        find(scene, frame, atSurface);
        find(scene, 0, atRest);
        lampFrameEmission =
                scene.routes.route(0, scene.world.lamps().get(0).frame()).transform(emission());
    }

    private void find(MovingRow scene, int frame, Sightline sight) {
        Event there = scene.routes.route(0, frame).transform(hit);
        Hit memory = Hit.blank();
        memory.setPlace(frame, there.x(), there.y(), there.z(), there.time());
        memory.eventMemory().setPlace(0, hit.x(), hit.y(), hit.z(), hit.time());
        if (!scene.retardedLight().find(0, memory, sight)) {
            throw new IllegalStateException("no light");
        }
    }

    private static Vector3d vector(Sightline sight) {
        return new Vector3d(sight.x, sight.y, sight.z);
    }

    /** Unit vector to the lamp in the frame of the surface. */
    Vector3d direction() {
        return Vectors.unit(vector(atSurface));
    }

    /** Length of the way in the frame of the surface. */
    double length() {
        return vector(atSurface).length();
    }

    /** Length of the way in the scene. */
    double lengthInScene() {
        return vector(atRest).length();
    }

    /** Where and when in the scene the light has left the lamp. */
    Event emission() {
        return hit.plus(new Event(atRest.x, atRest.y, atRest.z, -lengthInScene() * atRest.slowness));
    }
}
