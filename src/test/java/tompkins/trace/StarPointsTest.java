package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.camera.CameraRays;
import tompkins.camera.Cameras;
import tompkins.ray.Colour;
import tompkins.sceneobject.Plane;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.IdentityTransformation;
import tompkins.surface.ColouredSurface;

class StarPointsTest {

    private static final int SIDE = 100;

    /** Stars that are not in the picture take nothing from the disc of one that is, as large as half of the picture. */
    @Test
    void aLargeDiscIsEvenUnderASkyOfManyStars() {
        Vector3dc ahead = new Vector3d(0, 0, 1);
        Plane focus = new Plane("focus", new Vector3d(0, 0, 4), ahead, ColouredSurface.DEFAULT);
        CameraRays camera = Cameras.lens(
                        new Vector3d(), ahead, new Vector3d(0, 1, 0), 90, 0, 2, focus, 0, AperturePlaneShutter.DEFAULT)
                .rays(SIDE, SIDE, new IdentityTransformation());
        List<Vector3dc> stars = new ArrayList<>(Collections.nCopies(8000, new Vector3d(1, 0, 0)));
        stars.add(ahead);
        List<Colour> lights = Collections.nCopies(stars.size(), Colour.grey(1));
        StarPoints points = new StarPoints(camera, SIDE, SIDE, true, stars, lights, () -> false);

        double even = 1 / (Math.PI * 25 * 25);
        for (int row = 0; row < SIDE; row++) {
            for (int column = 0; column < SIDE; column++) {
                double away = Math.hypot(column + 0.5 - 50, row + 0.5 - 50);
                double light = points.light(column, row).green() * camera.solidAngle(column, row);
                if (away < 22) {
                    assertThat(light / even).isCloseTo(1, within(0.1));
                } else if (away > 28) {
                    assertThat(light).isZero();
                }
            }
        }
    }
}
