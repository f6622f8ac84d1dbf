package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.fuzz.RandomStudio;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.render.RenderReport;
import tompkins.sceneobject.SampleShapes;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.Velocity;
import tompkins.studio.UniformBackground;
import tompkins.surface.Clear;
import tompkins.surface.ColourFilter;
import tompkins.surface.ComplexRefraction;
import tompkins.surface.ConfocalLensletArray;
import tompkins.surface.IdealLens;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Mirror;
import tompkins.surface.Mixture;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;
import tompkins.surface.Tiling;
import tompkins.surface.TwoSided;
import tompkins.surface.WindowAxes;

/** A furnace: in a uniform glow nothing that neither lights nor absorbs can be seen. */
class EnergyTest {

    private static final Colour GLOW = new Colour(0.25, 0.5, 1);

    static Stream<Arguments> invisible() {
        List<Surface> surfaces = List.of(
                Clear.DEFAULT,
                ColourFilter.DEFAULT,
                new Mirror(1),
                new Refractive(1.5),
                new Refractive(1 / 1.5),
                new Refractive(2.4),
                new Refractive(1 + 1e-9),
                new LorentzWindow(Velocity.of(0.3, 0.2, -0.6), WindowAxes.FRAME, 1),
                new ConfocalLensletArray(2, -0.5, 0.3, -0.2, 1),
                new ComplexRefraction(1, 50, 1),
                new IdealLens(-1.5, 0.4, 0.6, 1),
                new Mixture(new Mirror(1), Clear.DEFAULT, 0.7),
                new TwoSided(Clear.DEFAULT, new ConfocalLensletArray(2, 2, 0, 0, 1)),
                new Tiling(new Mirror(1), new Refractive(1.5), 0.1, 0.1, true),
                new Tiling(new Refractive(1.5), new Mirror(1), 0.01, 0.01, true),
                new Tiling(Clear.DEFAULT, new Tiling(new Mirror(1), new Refractive(2), 0.1, 0.1, true), 1, 1, true));
        return surfaces.stream().flatMap(surface -> solids(surface).map(solid -> Arguments.of(solid, surface)));
    }

    private static Stream<SceneObject> solids(Surface surface) {
        return SampleShapes.closed(new Vector3d(0.1, 0, 9), 1, surface);
    }

    @ParameterizedTest
    @MethodSource("invisible")
    void nothingIsLostOrInvented(SceneObject solid, Surface surface) {
        Photograph photograph = glowing(List.of(solid), Velocity.of(0, 0, 0.1), 24);
        RenderReport report = photograph.job().report();
        assertWithin(photograph, 1 - 1e-6, surface);
        assertThat(report.counts().tooFaint + report.counts().tooDeep).isZero();
    }

    /** Each fills the same place as a piece of glass. */
    @ParameterizedTest
    @MethodSource("invisible")
    void nothingIsLostWhereSurfacesTouch(SceneObject solid, Surface surface) {
        SceneObject glass = solids(new Refractive(1.4))
                .filter(each -> each.getClass() == solid.getClass())
                .findFirst()
                .orElseThrow();
        Photograph photograph = glowing(List.of(solid, glass), Velocity.REST, 8);
        assertWithin(photograph, 0, surface);
        float[] rgb = photograph.image().rgb();
        assertThat(rgb[rgb.length / 2 / 3 * 3]).isGreaterThan((float) (0.9 * GLOW.red()));
    }

    static Stream<Class<?>> surfaces() {
        return Descriptions.members(Surface.class).stream();
    }

    /** Without lamps of their own, no kinds of surfaces make more light than there is. */
    @ParameterizedTest
    @MethodSource("surfaces")
    void noSurfaceInventsLight(Class<?> type) {
        for (int seed = 0; seed < 10; seed++) {
            Surface surface = RandomStudio.surface(seed, type);
            if (surface.toString().contains("Luminous") || surface.toString().contains("PictureSurface")) {
                continue;
            }
            List<SceneObject> solids = solids(surface).limit(2).toList();
            assertWithin(glowing(solids, Velocity.REST, 12), 0, surface);
        }
    }

    /** All of a picture has at least a share of the glow, and no more than the glow. */
    private static void assertWithin(Photograph photograph, double least, Surface surface) {
        float[] rgb = photograph.image().rgb();
        double[] glow = {GLOW.red(), GLOW.green(), GLOW.blue()};
        for (int i = 0; i < rgb.length; i++) {
            assertThat(rgb[i] / glow[i % 3])
                    .as("%s of %s", photograph.studio().scene(), surface)
                    .isBetween(least, 1 + 1e-6);
        }
    }

    private static Photograph glowing(List<SceneObject> scene, Velocity velocity, int size) {
        return new Photograph(Descriptions.with(
                Photograph.of(scene, Photograph.pinhole(new Vector3d(0, 0, 1), 20, 0), velocity, size, size)
                        .studio(),
                "background",
                new UniformBackground(GLOW)));
    }
}
