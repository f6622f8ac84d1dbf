package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.Camera;
import tompkins.light.AmbientLight;
import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.surface.ColouredSurface;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** What is known of wheels that roll without slipping, in photographs. */
class WheelFactsTest {

    private static final double SPEED = 0.8;
    private static final double GAMMA = 1 / Math.sqrt(1 - SPEED * SPEED);
    private static final double FAR = 1e5;

    /** A small ball on a wheel of radius 1 that rolls along a direction. */
    private static Studio studio(
            Vector3d along, Vector3d axis, Vector3d ball, double phase, Vector3d aim, double time) {
        SceneObject point = new Sphere("ball", ball, 1e-3, new ColouredSurface(Colour.WHITE, Colour.BLACK));
        Rotating wheel = new Rotating("wheel", new Vector3d(), axis, -SPEED, phase, List.of(point));
        Moving rolling = new Moving(
                "rolling", Velocity.of(new Vector3d(along).mul(SPEED)), new Vector3d(0, 0, FAR), 0, List.of(wheel));
        Studio studio =
                Lighting.of(Studio.DEFAULT.withScene(List.of(rolling)), List.of(new AmbientLight(Colour.grey(1e-4))));
        Camera camera = Descriptions.with(studio.camera(), "viewDirection", aim);
        return studio.withCamera(camera.withShutter(new AperturePlaneShutter(time)));
    }

    private static SampleHistory middle(Studio studio) {
        RenderPlan plan = RenderPlan.of(studio);
        return SampleHistory.of(plan, plan.width() / 2.0, plan.height() / 2.0, 0, 0);
    }

    /** Head-on, the point at the road has D = 1, the hub that of its speed, and the top its square. */
    @ParameterizedTest
    @CsvSource({"-1, 1", "0.001, 3.0", "1, 9"})
    void headOnFrequenciesGrowUpwards(double height, double factor) {
        Vector3d aim = new Vector3d(0, height, FAR);
        Studio studio =
                studio(new Vector3d(0, 0, -1), new Vector3d(1, 0, 0), new Vector3d(0, height, 0), 0, aim, aim.length());

        SampleHistory life = middle(studio);

        assertThat(life.end()).as("the ball is seen").isNotNull();
        assertThat(life.dopplerFactor()).isCloseTo(factor, within(0.02 * factor));
        Colour seen = middle(studio.withColours(ColourLaw.SEARCHLIGHT).withMetering(Metering.NONE))
                .colour();
        assertThat(seen.red()).isCloseTo(1e-4 * Math.pow(life.dopplerFactor(), 4), within(1e-9));
    }

    /** At one time of the road, the places on the wheel obey Kepler's equation. */
    @ParameterizedTest
    @CsvSource({"0.9, 0.3", "0.9, 2", "0.5, 1.2", "0.9, -2.5"})
    void measuredPlacesObeyKeplersEquation(double radius, double anomaly) {
        double mean = anomaly - SPEED * SPEED * radius * Math.sin(anomaly);
        // the angle from the lowest point, against the turn of the wheel, at time 0 of the hub
        Vector3d ball = new Vector3d(-radius * Math.sin(mean), -radius * Math.cos(mean), 0);
        Vector3d place = new Vector3d(-radius / GAMMA * Math.sin(anomaly), -radius * Math.cos(anomaly), FAR);
        Studio studio = studio(new Vector3d(1, 0, 0), new Vector3d(0, 0, 1), ball, 0, place, 0);

        SampleHistory life = middle(studio.withView(View.MEASURED));

        assertThat(life.end()).as("the ball is there").isNotNull();
        assertThat(life.end().event().position().distance(place)).isLessThan(2e-3);
    }

    /** A clock at the rim counts less than the hub's. */
    @Test
    void rimClocksFallBehind() {
        double time = 2 * Math.PI / SPEED;
        // after one turn of the hub's time, where it began
        Vector3d ball = new Vector3d(0, 0.75, 0);
        double sceneTime = GAMMA * time;
        Vector3d aim = new Vector3d(SPEED * sceneTime, 0.75, FAR);
        Studio studio = studio(new Vector3d(1, 0, 0), new Vector3d(0, 0, 1), ball, 0, aim, sceneTime + aim.length());

        SampleHistory.Rest rest = middle(studio).end().rest();

        assertThat(rest.event().time()).isCloseTo(time * Math.sqrt(1 - 0.6 * 0.6), within(0.01));
        assertThat(rest.event().position().distance(ball)).isLessThan(2e-3);
        assertThat(rest.velocity().length()).isCloseTo(0.6, within(0.001));
    }
}
