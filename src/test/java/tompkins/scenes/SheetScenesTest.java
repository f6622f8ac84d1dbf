package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.ConfocalLensletArray;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** Lenslets in place of the Lorentz window of Fig. 4, and a telescope before the camera. */
class SheetScenesTest {

    private static Vector3d sceneDirection(RenderPlan plan, double x, double y) {
        return new Vector3d(SampleHistory.of(plan, x, y, 0, 0).sceneDirection());
    }

    /** In degrees. */
    private static double angle(Vector3dc one, Vector3dc other) {
        return Math.toDegrees(2 * Math.asin(one.distance(other) / 2));
    }

    /**
     * By how many degrees lenslets turn light elsewhere than the window of Fig. 4 does, which undoes all aberration:
     * not at all in the middle, by a square of the slope around it, and by 0.28 degrees in the worst corner, as another
     * program finds that applies equation (2) of the paper to the directions behind the sheet.
     */
    @Test
    void lensletsImitateTheWindowInTheMiddle() {
        RenderPlan window = RenderPlan.of(SceneFiles.read("fig4"));
        RenderPlan lenslets = RenderPlan.of(SceneFiles.read("fig4-lenslets"));
        double[] error = new double[] {
            error(window, lenslets, 320, 240),
            error(window, lenslets, 322, 239),
            error(window, lenslets, 324, 238),
            error(window, lenslets, 640, 480),
            error(window, lenslets, 640, 0),
            error(window, lenslets, 0, 0),
            error(window, lenslets, 0, 480)
        };
        assertThat(error[0]).isLessThan(1e-11);
        assertThat(error[2] / error[1]).isCloseTo(4, within(0.02));
        assertThat(error[3]).isCloseTo(0.2763303, within(1e-6));
        assertThat(error[4]).isCloseTo(0.2481676, within(1e-6));
        assertThat(error[5]).isCloseTo(0.0366904, within(1e-6));
        assertThat(error[6]).isCloseTo(0.1655476, within(1e-6));
    }

    private static double error(RenderPlan window, RenderPlan lenslets, double x, double y) {
        return angle(sceneDirection(window, x, y), sceneDirection(lenslets, x, y));
    }

    /**
     * The magnifications and the slope of the scene are those of the window in the middle of the picture: slopes behind
     * it, divided by slopes before it.
     */
    @Test
    void magnificationsAreThoseOfTheWindow() {
        Studio figure = SceneFiles.read("fig4");
        ConfocalLensletArray sheet = (ConfocalLensletArray)
                ((Parallelogram) SceneFiles.read("fig4-lenslets").cameraFrame().get(0)).surface();
        Vector3d u = new Vector3d(figure.velocity().proper());
        double gamma = figure.velocity().gamma();
        Vector3d along = new Vector3d(u.x, u.y, 0).normalize();
        Vector3d across = new Vector3d(-along.y, along.x, 0);
        double step = 1e-5;
        double middle = slope(u, gamma, along, new Vector3d(0, 0, 1));
        double beside = slope(u, gamma, along, new Vector3d(0, 0, 1).fma(step, along));
        double before = slope(u, gamma, along, new Vector3d(0, 0, 1).fma(-step, along));
        double aside = slope(u, gamma, across, new Vector3d(0, 0, 1).fma(step, across));
        assertThat(sheet.etaU()).isCloseTo(2 * step / (beside - before), within(1e-6));
        assertThat(sheet.etaV()).isCloseTo(step / aside, within(1e-6));
        assertThat(sheet.deltaU()).isCloseTo(-sheet.etaU() * middle, within(1e-12));
        assertThat(sheet.deltaV()).isZero();
    }

    /** The slope along an axis behind a Lorentz window. */
    private static double slope(Vector3dc u, double gamma, Vector3dc axis, Vector3dc direction) {
        Vector3d behind = new Vector3d(direction).fma(u.dot(direction) / (gamma + 1) + direction.length(), u);
        return behind.dot(axis) / behind.z;
    }

    /** In front of the telescope, tangents of angles are a third; so they are behind lenslets that magnify 3 times. */
    @Test
    void theTelescopeDividesTangentsByThree() {
        Studio scene = SceneFiles.read("telescope");
        Disc eyepiece = (Disc) scene.cameraFrame().get(0);
        SceneObject sheet =
                new Disc("sheet", eyepiece.centre(), new Vector3d(0, 0, 1), 1, new ConfocalLensletArray(3, 3, 0, 0, 1));
        RenderPlan lenslets = RenderPlan.of(scene.withCameraFrame(List.of(sheet)));
        RenderPlan without = RenderPlan.of(scene.withCameraFrame(List.of()));
        RenderPlan telescope = RenderPlan.of(scene);
        int width = scene.settings().width();
        int height = scene.settings().height();
        for (int x = 0; x <= width; x += width / 8) {
            for (int y = 0; y <= height; y += height / 8) {
                SampleHistory seen = SampleHistory.of(telescope, x, y, 0, 0);
                assertThat(seen.sceneDirection().distance(sceneDirection(lenslets, x, y)))
                        .isLessThan(1e-14);
                assertThat(seen.mainHits()).hasSizeGreaterThanOrEqualTo(2);
                double third = width / 2.0 + (x - width / 2.0) / 3;
                double thirdDown = height / 2.0 + (y - height / 2.0) / 3;
                assertThat(seen.sceneDirection().distance(sceneDirection(without, third, thirdDown)))
                        .isLessThan(1e-14);
            }
        }
    }

    /** Sheets answer in their own frame: a scene that flies along with the camera shows what it shows at rest. */
    @ParameterizedTest
    @ValueSource(strings = {"surface-ideal-lens", "surface-confocal-lenslets"})
    void sheetsMayMove(String name) {
        Studio resting = SceneFiles.read(name);
        Velocity velocity = Velocity.of(0.3, 0.1, -0.6);
        RenderPlan still = RenderPlan.of(resting);
        RenderPlan flying = RenderPlan.of(resting.withVelocity(velocity)
                .withScene(List.of(new Moving("all", velocity, new Vector3d(), 0, resting.scene()))));
        int turned = 0;
        for (int x = 0; x <= resting.settings().width(); x += 20) {
            for (int y = 7; y <= resting.settings().height(); y += 20) {
                SampleHistory life = SampleHistory.of(still, x, y, 0, 0);
                List<SampleHistory.Encounter> hits = life.mainHits();
                List<SampleHistory.Encounter> same =
                        SampleHistory.of(flying, x, y, 0, 0).mainHits();
                assertThat(same).hasSameSizeAs(hits);
                for (int i = 0; i < hits.size(); i++) {
                    Vector3d place = new Vector3d(hits.get(i).rest().event().position());
                    assertThat(place.distance(same.get(i).rest().event().position()))
                            .isLessThan(1e-11 * (1 + place.length()));
                }
                turned += hits.size() > 1 ? 1 : 0;
            }
        }
        assertThat(turned).isGreaterThan(20);
    }
}
