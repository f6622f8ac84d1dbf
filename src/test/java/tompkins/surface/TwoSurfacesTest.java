package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.primitive.Primitive;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** Surfaces on two sides, and two surfaces in one place. */
class TwoSurfacesTest {

    private static final Surface RED = new LuminousSurface(new Colour(1, 0, 0), false);
    private static final Surface GREEN = new LuminousSurface(new Colour(0, 1, 0), false);
    private static final Surface BLUE = new LuminousSurface(new Colour(0, 0, 1), false);

    private static SceneObject disc(double z, double normal, Surface surface) {
        return new Disc("disc", new Vector3d(0, 0, z), new Vector3d(0.1, 0.2, normal), 2, surface);
    }

    /** What is seen straight ahead of the origin. */
    private static Colour ahead(SceneObject... objects) {
        Studio studio = Studios.dark().withScene(List.of(objects)).withVelocity(Velocity.REST);
        return SampleHistory.of(
                        RenderPlan.of(studio),
                        studio.settings().width() / 2.0,
                        studio.settings().height() / 2.0,
                        0,
                        0)
                .colour();
    }

    @ParameterizedTest
    @CsvSource({"-1, 1, 0", "1, 0, 1"})
    void eachSideShowsItsOwnSurface(double normal, double red, double green) {
        SceneObject sheet = disc(5, normal, new TwoSided(RED, GREEN));
        assertThat(ahead(sheet)).isEqualTo(new Colour(red, green, 0));
        SceneObject half = new Placed("", sheet, 0.5, new Vector3d(1, 1, 0), 0, new Vector3d(0, 0, 1));
        assertThat(ahead(half)).isEqualTo(new Colour(red, green, 0));
        SceneObject turned = new Placed("", sheet, 1, new Vector3d(0, 1, 0), 180, new Vector3d(0, 0, 10));
        assertThat(ahead(turned)).isEqualTo(new Colour(1 - red, 1 - green, 0));
    }

    @Test
    void glassIsRefusedOnOneSide() {
        Surface glass = new Tiling(Clear.DEFAULT, new Mixture(Refractive.DEFAULT, Clear.DEFAULT, 0.5), 1, 1, true);
        assertThatExceptionOfType(InvalidPropertyException.class)
                .isThrownBy(() -> new TwoSided(ColouredSurface.DEFAULT, glass))
                .withMessage("inside must be without Refractive in it, because a medium has two sides,"
                        + " was one with Refractive");
        assertThatExceptionOfType(InvalidPropertyException.class)
                .isThrownBy(() -> new TwoSided(Refractive.DEFAULT, Mirror.DEFAULT))
                .withMessageStartingWith("outside must be");
    }

    /** A fraction of one and the rest of the other, and of what is behind. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.25, 0.5, 0.75, 1})
    void mixturesAreMeans(double share) {
        SceneObject behind = disc(9, -1, BLUE);
        assertIs(ahead(disc(5, -1, new Mixture(RED, GREEN, share)), behind), 1 - share, share, 0);
        assertIs(ahead(disc(5, -1, new Mixture(RED, Clear.DEFAULT, share)), behind), 1 - share, 0, share);
        assertIs(ahead(disc(5, -1, new Mixture(Clear.DEFAULT, GREEN, share)), behind), 0, share, 1 - share);
        SceneObject two = new Group(
                "",
                List.of(
                        disc(5, -1, new Mixture(RED, Clear.DEFAULT, share)),
                        disc(6, -1, new Mixture(GREEN, Clear.DEFAULT, share))));
        assertIs(ahead(two, behind), 1 - share, share * (1 - share), share * share);
    }

    private static void assertIs(Colour found, double red, double green, double blue) {
        assertThat(new double[] {found.red(), found.green(), found.blue()})
                .containsExactly(new double[] {red, green, blue}, within(1e-12));
    }

    @Test
    void mixturesThrowAShadowWhereBothDo() {
        Surface opaque = ColouredSurface.DEFAULT;
        Surface tiles = new Tiling(opaque, Clear.DEFAULT, 0.5, 0.5, true);
        assertThat(new Mixture(opaque, Mirror.DEFAULT, 0.5).shadow()).isEqualTo(Shadow.ALWAYS);
        assertThat(new Mixture(opaque, Clear.DEFAULT, 0.5).shadow()).isEqualTo(Shadow.NEVER);
        assertThat(new Mixture(opaque, Clear.DEFAULT, 0).shadow()).isEqualTo(Shadow.ALWAYS);
        assertThat(new Mixture(Clear.DEFAULT, opaque, 1).shadow()).isEqualTo(Shadow.ALWAYS);
        assertThat(new Mixture(tiles, opaque, 0.5).shadow()).isEqualTo(Shadow.BY_POINT);
        assertThat(new Mixture(tiles, opaque, 0.5).usesCoordinates()).isTrue();
        Disc disc = new Disc("", new Vector3d(0, 0, 5), new Vector3d(0, 0, -1), 2, new Mixture(opaque, tiles, 0.5));
        Primitive sheet = PrimitiveCollector.primitivesOf(disc).get(0);
        // on a tile that is opaque, and on one that is clear
        assertThat(sheet.shadows(Ray.from(0.5, 0.5, 0, 0, 0, 1, 0), 9)).isTrue();
        assertThat(sheet.shadows(Ray.from(0.5, -0.5, 0, 0, 0, 1, 0), 9)).isFalse();
    }

    /** The middles of the segments from a to g, and the digits that have them; these stand behind a 1. */
    @ParameterizedTest
    @CsvSource({
        "0, 0.5, 02356789",
        "0.25, 0.25, 01234789",
        "0.25, -0.25, 013456789",
        "0, -0.5, 0235689",
        "-0.25, -0.25, 0268",
        "-0.25, 0.25, 045689",
        "0, 0, 2345689"
    })
    void clockShowsDigits(double x, double y, String digits) {
        for (int digit = 0; digit < 10; digit++) {
            assertThat(SevenSegments.isLit(10 + digit, x + 0.35, y))
                    .as("%s", digit)
                    .isEqualTo(digits.indexOf('0' + digit) >= 0);
        }
    }

    /** By the middle of the first character: a number of more than five of them is not shown. */
    @ParameterizedTest
    @CsvSource({"-9999, -1.4, true", "88888, -1.4, true", "-10000, -1.75, false", "888888, -1.75, false"})
    void clockShowsFiveCharacters(double number, double x, boolean isLit) {
        assertThat(SevenSegments.isLit(number, x, 0)).isEqualTo(isLit);
    }
}
