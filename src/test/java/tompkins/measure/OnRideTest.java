package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.ThinLensCamera;
import tompkins.lesson.LessonControl;
import tompkins.lesson.OnRide;
import tompkins.lesson.PicturePoint;
import tompkins.lesson.RayReading;
import tompkins.lesson.RayValue;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.sceneobject.Disc;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.studio.RideLeg;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.LuminousSurface;

/** What is measured in photographs of a ride away and back with the proper acceleration 1, against closed formulas. */
class OnRideTest {

    private static final double LEG = 1.5;

    /** The camera begins 2 before a disc, at time 2, when it sees the time 0 there, and looks at it all the time. */
    private static double timeSeenAtHome(double properTime) {
        Studio start = Studios.dark()
                .withScene(List.of(
                        new Disc("home", new Vector3d(0, 0, 2), new Vector3d(0, 0, -1), 1, LuminousSurface.DEFAULT)))
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d())
                        .withShutter(new AperturePlaneShutter(2)));
        Studio studio = start.withRide(List.of(leg(LEG, -1), leg(2 * LEG, 1), leg(LEG, -1)));
        RayReading reading = new RayReading(PicturePoint.DEFAULT, RayValue.TIME);
        return new Experiment(studio, LessonControl.DEFAULT).measure(new OnRide(properTime, reading), "measurement");
    }

    private static RideLeg leg(double properTime, double forwards) {
        return Descriptions.with(
                Descriptions.with(RideLeg.DEFAULT, "properTime", properTime),
                "acceleration",
                new Vector3d(0, 0, forwards));
    }

    /**
     * With thrust away the light that is met at the own time s left home at 1 - exp(-s), until the turn at 2 - 2
     * exp(-1.5); in all the time 4 sinh 1.5 passes at home.
     */
    @ParameterizedTest
    @CsvSource({"0, 0", "0.7, 0.503414696", "1.5, 0.776869840", "3, 1.553739680", "6, 8.517117820"})
    void homeIsSeenAtTheTimesOfTheFormulas(double properTime, double seen) {
        assertThat(timeSeenAtHome(properTime)).isCloseTo(seen, within(1e-8));
    }

    @Test
    void afterTheEndNothingIsMeasured() {
        assertThatThrownBy(() -> timeSeenAtHome(6.1))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessage("measurement: properTime must be from 0 to 6, was 6.1");
    }
}
