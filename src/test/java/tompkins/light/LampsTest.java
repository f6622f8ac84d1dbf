package tompkins.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.assertj.core.data.Offset;
import org.joml.Vector3d;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** What a surface sends back of the light of its lamps, against Lambert's and Phong's laws in angles. */
class LampsTest {

    private static final Offset<Double> ROUNDING = within(1e-9);
    private static final Colour DIFFUSE = new Colour(0.2, 0.3, 0.5);
    private static final Colour SPECULAR = new Colour(0.7, 0.11, 0.13);
    private static final Colour LIGHT = new Colour(2, 3, 5);
    private static final Colour HIGHLIGHT = new Colour(7, 11, 13);

    private final Vector3d place = new Vector3d();
    private final Vector3d normal = new Vector3d();
    private final Vector3d ray = new Vector3d();
    private final Vector3d lamp = new Vector3d();
    private boolean gets = true;
    private boolean isClear = true;
    private LightShift shift;
    private double frequency = 1;

    /** Lamps whose light has half the frequency at the surface. */
    private final Lighting lighting = new Lighting() {
        @Override
        public boolean find(int source, Hit hit, Sightline sight) {
            sight.set(lamp.x - hit.x, lamp.y - hit.y, lamp.z - hit.z, 0.5, 1, 0);
            return gets;
        }

        @Override
        public boolean isClear(int source, Hit hit, Sightline sight) {
            return isClear;
        }
    };

    private Colour reflected(RestingLight... sources) {
        Ray hitting = Ray.from(place.x - ray.x, place.y - ray.y, place.z - ray.z, ray.x, ray.y, ray.z, 0);
        Hit hit = Hit.blank().set(hitting, 1, normal.x, normal.y, normal.z, null, 0, null);
        return illumination(sources).reflected(at(frequency, hitting), hit, DIFFUSE, SPECULAR);
    }

    private Illumination illumination(RestingLight... sources) {
        return new Illumination(List.of(sources), lighting, shift);
    }

    /** The ray, of light in vacuum that has another frequency at the camera. */
    private static Ray at(double frequency, Ray ray) {
        ray.frequency = frequency;
        ray.directionLength = frequency;
        return ray;
    }

    private PointLight lamp(double exponent) {
        return new PointLight(lamp, LIGHT, HIGHLIGHT, exponent);
    }

    private static void assertClose(Colour colour, double red, double green, double blue) {
        assertThat(colour.red()).isCloseTo(red, ROUNDING);
        assertThat(colour.green()).isCloseTo(green, ROUNDING);
        assertThat(colour.blue()).isCloseTo(blue, ROUNDING);
    }

    private static Vector3d direction(Random random) {
        return new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalize();
    }

    @RepeatedTest(50)
    void lampsShineAsLambertAndPhongSay(RepetitionInfo repetition) {
        Random random = new Random(repetition.getCurrentRepetition());
        place.set(direction(random));
        normal.set(direction(random));
        ray.set(direction(random));
        lamp.set(place).fma(3 + random.nextDouble(), direction(random));
        Vector3d toLamp = lamp.sub(place, new Vector3d()).normalize();
        Vector3d towardsViewer = ray.negate(new Vector3d());
        boolean onOneSide = normal.dot(toLamp) * normal.dot(towardsViewer) > 0;
        double dull = onOneSide ? Math.abs(Math.cos(normal.angle(toLamp))) : 0;
        // the lamp as the surface mirrors it, half a turn around the normal
        Vector3d mirrored = new Vector3d(toLamp).rotateAxis(Math.PI, normal.x, normal.y, normal.z);
        double cosine = Math.cos(mirrored.angle(towardsViewer));
        double shine = onOneSide && cosine > 0 ? cosine * cosine * cosine : 0;

        assertClose(
                reflected(lamp(3)),
                0.2 * 2 * dull + 0.7 * 7 * shine,
                0.3 * 3 * dull + 0.11 * 11 * shine,
                0.5 * 5 * dull + 0.13 * 13 * shine);
    }

    private void standBefore() {
        normal.set(0, 0, -1);
        ray.set(0, 0, 1);
        lamp.set(0, 3, -4);
    }

    @Test
    void aLampIsFullyMirroredAlongTheNormal() {
        standBefore();
        lamp.set(0, 0, -4);

        assertClose(reflected(lamp(1000)), 0.4 + 4.9, 0.9 + 1.21, 2.5 + 1.69);
    }

    /** The highlight of exponent 0 is the same wherever the lamp is mirrored forwards. */
    @Test
    void lampsAndEvenLightAddUp() {
        standBefore();

        Colour all = reflected(lamp(0), new AmbientLight(new Colour(3, 10, 100)), lamp(0));

        assertClose(all, 2 * (0.4 * 0.8 + 4.9) + 0.6, 2 * (0.9 * 0.8 + 1.21) + 3, 2 * (2.5 * 0.8 + 1.69) + 50);
    }

    @Test
    void shadowsAndLateLampsAreDark() {
        standBefore();
        isClear = false;
        assertThat(reflected(lamp(3))).isEqualTo(Colour.BLACK);
        isClear = true;
        gets = false;
        assertThat(reflected(lamp(3))).isEqualTo(Colour.BLACK);
        gets = true;
        lamp.set(place);
        assertThat(reflected(lamp(3))).as("a lamp on the surface").isEqualTo(Colour.BLACK);
    }

    @Test
    void aLampInThePlaneOfTheSurfaceShinesOnIt() {
        standBefore();
        ray.set(0, -0.6, 0.8);
        lamp.set(0, -5, 0);

        assertClose(reflected(lamp(2)), 4.9 * 0.36, 1.21 * 0.36, 1.69 * 0.36);
    }

    /**
     * The searchlight effect is the fourth power of all frequency ratios: 4 from the surface to the camera, and 1/2
     * from the lamps to the surface, as the sight says; none of its own from even light.
     */
    @Test
    void lightIsSeenShifted() {
        standBefore();
        shift = new LightShift(ColourLaw.SEARCHLIGHT, Metering.NONE, 1, 1);
        frequency = 0.25;

        Colour seen = reflected(lamp(0), new AmbientLight(new Colour(3, 10, 100)));

        assertClose(
                seen,
                16 * (0.4 * 0.8 + 4.9) + 256 * 0.6,
                16 * (0.9 * 0.8 + 1.21) + 256 * 3,
                16 * (2.5 * 0.8 + 1.69) + 256 * 50);
        assertClose(illumination().emitted(at(0.25, Ray.blank()), LIGHT), 512, 768, 1280);
        shift = null;
        assertThat(illumination().emitted(at(0.25, Ray.blank()), LIGHT)).isEqualTo(LIGHT);
    }
}
