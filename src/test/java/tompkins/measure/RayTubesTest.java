package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.Clear;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.surface.WindowAxes;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

class RayTubesTest {

    private static final Vector3d BACK = new Vector3d(0, 0, -1);

    private static Studio studio(SceneObject... objects) {
        return Studio.DEFAULT
                .withSettings(Studio.DEFAULT.settings().withSize(40, 30))
                .withScene(List.of(objects));
    }

    /** The ray of the middle of the picture, which runs along z. */
    private static SampleHistory middle(Studio studio) {
        return SampleHistory.of(RenderPlan.of(studio), 20, 15, 0, 0);
    }

    private static <T> List<T> parts(Group group, Class<T> type) {
        return group.objects().stream().filter(type::isInstance).map(type::cast).toList();
    }

    /**
     * Straight through a plate of glass from z = 5 to 6, 4 % of the light turn back at each face; of those that turn
     * back at the second face 4 % do so at the first again. What is fainter than 1/1024 is not followed.
     */
    @Test
    void eachBranchBeginsWhereItLeft() {
        Box plate = new Box("plate", new Vector3d(-9, -9, 5), new Vector3d(9, 9, 6), new Refractive(1.5));

        Group tubes = RayTubes.of("ray", List.of(middle(studio(plate))));

        // the farthest hit is at 6, and the median one of 5 5 6 6; within 30 radii of the lens nothing is drawn
        double radius = 6 / 250.0;
        double near = 30 * radius;
        List<Cylinder> rods = parts(tubes, Cylinder.class);
        double[][] expected = {
            {near, 5}, {5, near}, {-near, -1}, {5, 6}, {6, 5}, {5, 6}, {6, 12}, {5, near}, {-near, -1}, {6, 12}
        };
        assertThat(rods).hasSize(expected.length);
        for (int i = 0; i < expected.length; i++) {
            assertThat(rods.get(i).start().z()).isCloseTo(expected[i][0], within(1e-14));
            assertThat(rods.get(i).end().z()).isCloseTo(expected[i][1], within(1e-14));
        }
        // the pieces of most of the light are the first, the fourth and the last
        for (int i = 0; i < expected.length; i++) {
            assertThat(rods.get(i).surface().equals(rods.get(0).surface())).isEqualTo(i % 3 == 0 && i != 6);
        }
        assertThat(rods).allMatch(Cylinder::caps);
        assertThat(parts(tubes, Sphere.class).stream().map(ball -> ball.centre().z()))
                .containsExactly(5.0, 6.0, 5.0, 6.0);
        assertThat(tubes.objects())
                .allSatisfy(
                        part -> assertThat(part instanceof Cylinder rod ? rod.radius() : ((Sphere) part).radius() / 2)
                                .isCloseTo(radius, within(1e-15)));
    }

    /** A mirror at 45 degrees sends it to the right; the wall there is 3 away. */
    @Test
    void rodsMeetAtWhatTheyHit() {
        Studio corner = studio(
                new Plane("mirror", new Vector3d(0, 0, 4), new Vector3d(1, 0, -1), new Mirror(0.9)),
                new Plane("wall", new Vector3d(3, 0, 0), new Vector3d(-1, 0, 0), ColouredSurface.DEFAULT));

        Group tubes = RayTubes.of("ray", List.of(middle(corner)));

        List<Sphere> balls = parts(tubes, Sphere.class);
        List<Cylinder> rods = parts(tubes, Cylinder.class);
        assertThat(balls.get(0).centre().distance(0, 0, 4)).isLessThan(1e-14);
        assertThat(balls.get(1).centre().distance(3, 0, 4)).isLessThan(1e-14);
        assertThat(rods)
                .extracting(Cylinder::end)
                .containsExactly(balls.get(0).centre(), balls.get(1).centre());
        assertThat(rods.get(1).start()).isEqualTo(balls.get(0).centre());
        assertThat(tubes.objects())
                .extracting(SceneObject::description)
                .containsExactly("to mirror", "hit on mirror", "to wall", "hit on wall");
    }

    /** Behind a window before the lens a ray begins where it crosses that, at its event in the scene frame. */
    @Test
    void onlyWhatHappensInTheSceneIsDrawn() {
        Velocity velocity = Velocity.of(0, 0, 0.6);
        Disc window =
                new Disc("window", new Vector3d(0, 0, 1), BACK, 2, new LorentzWindow(velocity, WindowAxes.FRAME, 1));
        SceneObject wall = new Plane("wall", new Vector3d(0, 0, 40), BACK, ColouredSurface.DEFAULT);
        Disc pane = new Disc("pane", new Vector3d(0, 0, 0.5), BACK, 2, Clear.DEFAULT);
        Studio moving = studio(wall).withVelocity(velocity).withCameraFrame(List.of(window, pane));

        SampleHistory ray = middle(moving);
        Group tubes = RayTubes.of("ray", List.of(ray));

        assertThat(ray.hits()).hasSize(3);
        assertThat(parts(tubes, Sphere.class))
                .singleElement()
                .satisfies(ball -> assertThat(ball.centre().z()).isCloseTo(40, within(1e-12)));
        // one unit before the lens and so one unit earlier: gamma (z + beta t) is 1.25 (1 - 0.6)
        assertThat(ray.segments().get(0).start().z()).isCloseTo(0.5, within(1e-14));
        // 30/250 of the 39.5 from there to the wall
        assertThat(parts(tubes, Cylinder.class))
                .singleElement()
                .satisfies(rod -> assertThat(rod.start().z()).isCloseTo(0.5 + 39.5 * 30 / 250, within(1e-12)));
    }

    /** A wall that comes with 0.5 c from z = 9 at time 0 is met by the backward ray z = -t where 9 - 0.5 t = -t. */
    @Test
    void whatMovesIsMetWhereItWas() {
        Plane wall = new Plane("wall", new Vector3d(), BACK, ColouredSurface.DEFAULT);
        Velocity coming = Velocity.of(0, 0, -0.5);
        Group tubes = RayTubes.of(
                "ray", List.of(middle(studio(new Moving("", coming, new Vector3d(0, 0, 9), 0, List.of(wall))))));

        assertThat(parts(tubes, Sphere.class))
                .singleElement()
                .satisfies(ball -> assertThat(ball.centre().z()).isCloseTo(18, within(1e-12)));
    }

    /** Through the edge of a lens of radius 1/2 that is focused at 5 all rays meet there. */
    @Test
    void aConeThroughTheLensMeetsInTheFocus() {
        ThinLensCamera lens = Descriptions.with(
                Descriptions.with(ThinLensCamera.DEFAULT, "apertureRadius", 0.5),
                "focus",
                new Plane("focus", new Vector3d(0, 0, 5), BACK, ColouredSurface.DEFAULT));
        SceneObject wall = new Plane("wall", new Vector3d(0, 0, 5), BACK, ColouredSurface.DEFAULT);
        RenderPlan plan = RenderPlan.of(studio(wall).withCamera(Descriptions.with(lens, "exposureTime", 4.0)));

        List<SampleHistory> cone = RayTubes.cone(plan, 20, 15, 8, 0.25);

        assertThat(cone).hasSize(8);
        assertThat(cone).allSatisfy(ray -> {
            assertThat(ray.segments().get(0).start().position().length()).isCloseTo(0.5, within(1e-15));
            assertThat(ray.cameraStart().time()).isEqualTo(1);
            assertThat(ray.end().event().position().distance(0, 0, 5)).isLessThan(1e-14);
        });
    }

    @Test
    void aConeOfAPinholeSurroundsThePixel() {
        SceneObject wall = new Plane("wall", new Vector3d(0, 0, 5), BACK, ColouredSurface.DEFAULT);
        Studio studio = studio(wall);
        RenderPlan plan = RenderPlan.of(studio);

        List<SampleHistory> cone = RayTubes.cone(plan, 20, 15, 4, 0.5);
        Studio drawn = RayTubes.addedTo(studio, "cone", cone);

        // a twentieth of the height is 1.5 pixels
        double away = SampleHistory.of(plan, 21.5, 15, 0, 0).end().event().x();
        assertThat(cone.stream().map(ray -> ray.end().event().x()))
                .satisfiesExactly(
                        x -> assertThat(x).isCloseTo(away, within(1e-14)),
                        x -> assertThat(x).isCloseTo(0, within(1e-14)),
                        x -> assertThat(x).isCloseTo(-away, within(1e-14)),
                        x -> assertThat(x).isCloseTo(0, within(1e-14)));
        assertThat(drawn.scene()).hasSize(2);
        assertThat(((Group) drawn.scene().get(1)).objects())
                .hasSize(4)
                .allSatisfy(ray -> assertThat(((Group) ray).objects()).hasSize(2));
    }

    /** What hits nothing is drawn as far as new objects stand. */
    @Test
    void raysIntoNothingEnd() {
        Group tubes = RayTubes.of("ray", List.of(middle(studio())));

        assertThat(tubes.objects())
                .singleElement()
                .satisfies(rod -> assertThat(((Cylinder) rod).end().z()).isEqualTo(10));
        assertThat(RayTubes.canDraw(List.of())).isFalse();
        assertThat(Stream.of(middle(studio()))).allMatch(ray -> RayTubes.canDraw(List.of(ray)));
    }
}
