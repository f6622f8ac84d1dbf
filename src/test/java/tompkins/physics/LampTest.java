package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.light.PointLight;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Disc;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;

/** Which side of a sheet a lamp lights. */
class LampTest {

    @ParameterizedTest
    @CsvSource({"-3, true", "13, false"})
    void aSheetIsLitOnTheSideOfTheLampAlone(double z, boolean lit) {
        Disc disc = new Disc("", new Vector3d(0, 0, 5), new Vector3d(0, 0, -1), 2, ColouredSurface.DEFAULT);
        Studio dark = Photograph.of(
                        List.of(disc), Photograph.pinhole(new Vector3d(0, 0, 1), 10, 0), Velocity.of(0, 0, 0), 1, 1)
                .studio();
        PointLight lamp = new PointLight(new Vector3d(1, 2, z), Colour.WHITE, Colour.WHITE, 10);
        float red = new Photograph(Descriptions.with(dark, "lights", List.of(lamp)))
                .image()
                .value(0, 0, 0);
        assertThat(red > 0).isEqualTo(lit);
    }
}
