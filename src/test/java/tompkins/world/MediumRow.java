package tompkins.world;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.golden.GoldenRow;
import tompkins.light.Illumination;
import tompkins.math.Vectors;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Medium;
import tompkins.ray.Ray;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.LightInMedium;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Refractive;
import tompkins.surface.Tracer;

/** What a camera sees in a medium that moves, for a row of the reference data, by the parts that take pictures. */
final class MediumRow {

    private static final Vector3d OUT_OF_THE_WAY = new Vector3d(3e8, 2e8, -1e8);

    final LightInMedium light;

    /** Null where no light comes from. */
    final LightInMedium.Seen met;

    final LightInMedium.Seen overtaken;

    private final GoldenRow row;
    private final MovingRow scene;
    private final double index;
    private final int frame;

    MediumRow(GoldenRow row) {
        this.row = row;
        index = row.number("n");
        SceneObject wall = new Plane("", row.vector("q1_"), row.vector("q2_"), ColouredSurface.DEFAULT);
        SceneObject far = new Sphere("", OUT_OF_THE_WAY, 1, ColouredSurface.DEFAULT);
        scene = MovingRow.of(
                List.of(
                        MovingRow.moving(row.vector("v_"), row.vector("p_"), 0, wall),
                        MovingRow.moving(row.vector("vj_"), new Vector3d(), 0, far)),
                row.vector("beta_"),
                camera(),
                false);
        frame = frameOf(wall);
        light = new LightInMedium(index, scene.routes.motion(frame, scene.routes.camera()));
        Vector3d look = Vectors.unit(row.vector("d_"));
        met = light.met(look.x(), look.y(), look.z());
        overtaken = light.overtaken(look);
    }

    /** The slowness of light for the camera less 1, which keeps its digits where the slowness is about 1. */
    double slownessAboveVacuum(LightInMedium.Seen seen) {
        return (index - 1) * (index + 1) * seen.length() * seen.length() / (1 + light.slowness(seen.length()));
    }

    private Event camera() {
        Vector3d place = row.vector("o_");
        return new Event(place.x, place.y, place.z, row.number("ot"));
    }

    private int frameOf(SceneObject object) {
        for (int i = 0; i < scene.world.frames().size(); i++) {
            if (scene.world.objects(i).primitives().stream().anyMatch(primitive -> primitive.object() == object)) {
                return i;
            }
        }
        throw new IllegalStateException("nowhere");
    }

    /** The ray in the rest frame of the medium, as long and as frequent as at the camera. */
    Ray ray() {
        Event start = scene.routes.route(scene.routes.camera(), frame).transform(camera());
        Vector3dc direction = met.direction();
        Ray ray = Ray.from(start.x(), start.y(), start.z(), direction.x(), direction.y(), direction.z(), start.time());
        return ray.inFrame(frame)
                .in(new Medium(index, frame, null))
                .asWave(index, 1 / met.frequency())
                .stretched(met.length());
    }

    FoundHit hit() {
        return scene.find(ray());
    }

    /** The ray for the object that moves through the medium. */
    Ray forObject() {
        int other = scene.world.frames().size() - 1;
        boolean isApart =
                !row.vector("vj_").equals(row.vector("v_")) && row.vector("vj_").length() > 0;
        return scene.routes.transform(ray(), isApart ? other : frameOfScene(), Ray.blank());
    }

    /** An object with the velocity of the medium rests in its frame, one without a velocity in the scene frame. */
    private int frameOfScene() {
        return row.vector("vj_").equals(row.vector("v_")) ? frame : 0;
    }

    /** The ray behind the boundary to vacuum, in the frame of the medium; null if all light is mirrored. */
    Ray behindBoundary() {
        Ray before = ray();
        Vector3d normal = Vectors.unit(row.vector("nb_"));
        if (normal.dot(before.dx, before.dy, before.dz) < 0) {
            normal.negate();
        }
        Hit hit = Hit.blank().set(before, 1, normal.x, normal.y, normal.z, null, 0, null);
        List<Ray> after = new ArrayList<>();
        Tracer tracer = new Tracer() {
            @Override
            public Colour colour(Ray ray) {
                after.add(ray);
                return Colour.BLACK;
            }

            @Override
            public Illumination illumination() {
                throw new IllegalStateException("nothing is lit here");
            }

            @Override
            public boolean keepsMedia() {
                return true;
            }
        };
        after.add(new Refractive(index).respond(before, hit, tracer).next());
        return after.stream()
                .filter(ray -> ray.medium == null && normal.dot(ray.dx, ray.dy, ray.dz) > 0)
                .findFirst()
                .orElse(null);
    }

    /** That ray in the scene. */
    Ray inScene() {
        return scene.routes.transform(behindBoundary(), 0, Ray.blank());
    }
}
