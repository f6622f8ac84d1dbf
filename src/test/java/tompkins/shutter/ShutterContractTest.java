package tompkins.shutter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.lang.reflect.RecordComponent;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.fuzz.RandomStudio;
import tompkins.math.Vectors;
import tompkins.property.Descriptions;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;

/** What every shutter promises. */
class ShutterContractTest {

    private static final int RANDOM_ONES = 5;

    private static final SpaceTimeTransformation MOVING =
            TransformationLaw.LORENTZ.sceneFromCamera(Velocity.of(0.2, -0.1, 0.97));

    private final SplittableRandom random = new SplittableRandom(9);

    static Stream<Shutter> shutters() {
        return Descriptions.members(Shutter.class).stream()
                .flatMap(type -> Stream.concat(
                        Stream.of((Shutter) Descriptions.standard(type)),
                        LongStream.range(0, RANDOM_ONES).mapToObj(seed -> RandomStudio.shutter(seed, type))));
    }

    private LensRay lensRay(double inverseFocusDistance) {
        Vector3d chief = Vectors.unit(new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, 1));
        Vector3d centre = new Vector3d(1, 2, 3);
        Vector3d pupil = new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, 0)
                .mul(0.1)
                .add(centre);
        return new LensRay(centre, pupil, chief, inverseFocusDistance, new Vector3d(0, 0, 1));
    }

    @ParameterizedTest
    @MethodSource("shutters")
    void timesAreFiniteInFrontAndBehind(Shutter shutter) {
        for (double inverse : new double[] {1e-6, 0.1, 3, -3, -0.1, -1e-6}) {
            for (int i = 0; i < 50; i++) {
                assertThat(shutter.transmissionTime(lensRay(inverse), MOVING)).isFinite();
            }
        }
    }

    @ParameterizedTest
    @MethodSource("shutters")
    void onlyShuttersThatNeedAFocusHaveNoTimeAtInfinity(Shutter shutter) {
        assertThat(Double.isFinite(shutter.transmissionTime(lensRay(0), MOVING)))
                .isEqualTo(!shutter.needsFocus());
    }

    @ParameterizedTest
    @MethodSource("shutters")
    void openingLaterMovesAllTimes(Shutter shutter) {
        Shutter later = shutter.openedAt(shutter.openingTime() + 2.5);
        assertThat(later).isInstanceOf(shutter.getClass());
        LensRay ray = lensRay(0.2);
        double expected = shutter instanceof FixedPointSurfaceShutter ? 0 : 2.5;
        double moved = later.transmissionTime(ray, MOVING) - shutter.transmissionTime(ray, MOVING);
        assertThat(moved).isCloseTo(expected, within(1e-14 * (1 + Math.abs(shutter.transmissionTime(ray, MOVING)))));
        assertThat(later.openingTime() - shutter.openingTime()).isCloseTo(expected, within(1e-14));
    }

    @ParameterizedTest
    @MethodSource("shutters")
    void openingLaterChangesNothingElse(Shutter shutter) {
        Shutter later = shutter.openedAt(2.5);
        boolean hasOpeningTime = false;
        for (RecordComponent component : Descriptions.components(shutter.getClass())) {
            boolean isOpeningTime = component.getName().equals("openingTime");
            hasOpeningTime |= isOpeningTime;
            assertThat(Descriptions.value(component, later))
                    .as("%s of %s", component.getName(), later)
                    .isEqualTo(isOpeningTime ? 2.5 : Descriptions.value(component, shutter));
        }
        assertThat(shutter.hasOpeningTime()).isEqualTo(hasOpeningTime);
    }

    @Test
    void aNormalMayHaveAnyLength() {
        ArbitraryPlaneShutter shutter =
                new ArbitraryPlaneShutter(1, new Vector3d(0.1, 0.2, 5), new Vector3d(0, 0.6, 0.8));
        LensRay ray = lensRay(0.1);
        double time = shutter.transmissionTime(ray, MOVING);
        for (double length : new double[] {1e-300, 1e-160, 7, 1e160, 1e300}) {
            Vector3d normal = new Vector3d(0, 0.6, 0.8).mul(length);
            assertThat(new ArbitraryPlaneShutter(1, shutter.point(), normal).transmissionTime(ray, MOVING))
                    .isCloseTo(time, within(1e-14 * Math.abs(time)));
        }
    }
}
