package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2i;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.ArbitraryPlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.LensHologramShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.Velocity;
import tompkins.surface.ColouredSurface;
import tompkins.trace.SampleHistory;

/** The moving camera photographs the places of a grid as a regular grid, whatever its shutter and its focus. */
class ImagePointGridTest {

    static Stream<Arguments> shuttersAndFocuses() {
        List<Shutter> shutters = List.of(
                new AperturePlaneShutter(2),
                new DetectorPlaneShutter(2, 0.5),
                new LensHologramShutter(-1, 0.5),
                new FocusSurfaceShutter(3),
                new ArbitraryPlaneShutter(1, new Vector3d(0, 0, 4), new Vector3d(0.1, 0.2, 1)),
                new FixedPointSurfaceShutter());
        return shutters.stream()
                .flatMap(shutter -> Stream.of(5.0, 10.0, 20.0, -10.0).map(focus -> Arguments.of(shutter, focus)));
    }

    /** In a picture 90 degrees wide the slopes of the pixels' centres are -0.8, -0.4, 0, 0.4 and 0.8. */
    @ParameterizedTest
    @MethodSource("shuttersAndFocuses")
    void ballsAreSeenInTheirPixels(Shutter shutter, double focus) {
        ImagePointGrid grid = grid(3);
        SceneObject plane = new Plane(
                "focus", new Vector3d(0, 0, focus), new Vector3d(0.2, 0, 1).normalize(), ColouredSurface.DEFAULT);
        Camera camera = Descriptions.with(Photograph.pinhole(new Vector3d(0, 0, 1), 90, 0), "focus", plane)
                .withShutter(shutter);
        Photograph photograph = Photograph.of(List.of(grid), camera, Velocity.of(0.3, -0.4, 0.6), 5, 5);
        for (int row = 0; row < 5; row++) {
            for (int column = 0; column < 5; column++) {
                SampleHistory ray = photograph.trace(column + 0.5, row + 0.5);
                boolean inGrid = column > 0 && column < 4 && row > 0 && row < 4;
                assertThat(ray.hits()).as("column %d, row %d", column, row).hasSize(inGrid ? 1 : 0);
            }
        }
    }

    @Test
    void aSinglePointIsTheMiddle() {
        ThinLensCamera camera = Photograph.pinhole(new Vector3d(0, 0, 1), 90, 0);
        Photograph photograph = Photograph.of(List.of(grid(1)), camera, Velocity.of(0.3, -0.4, 0.6), 5, 5);
        for (int pixel = 0; pixel < 25; pixel++) {
            assertThat(photograph.trace(pixel % 5 + 0.5, pixel / 5 + 0.5).hits())
                    .as("pixel %d", pixel)
                    .hasSize(pixel == 12 ? 1 : 0);
        }
    }

    private static ImagePointGrid grid(int points) {
        return new ImagePointGrid(
                "grid",
                new Sphere("ball", new Vector3d(), 0.025, ColouredSurface.DEFAULT),
                new Vector3d(-4, -4, 10),
                new Vector3d(8, 0, 0),
                new Vector3d(0, 8, 0),
                new Vector2i(points, points));
    }
}
