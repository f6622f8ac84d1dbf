package tompkins.ui.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import tompkins.camera.SamplePositions;
import tompkins.measure.RayTubes;
import tompkins.measure.Sighting;
import tompkins.sceneobject.Group;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.ui.Components;
import tompkins.ui.WindowDriver;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Pictures;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

/** The section of the pinned ray, without a display. */
class RaySectionTest {

    private static final Studio STUDIO = Studios.sphere().withVelocity(Velocity.of(0, 0, 0.8));

    /** Who waits for a cone of rays. */
    private Consumer<List<SampleHistory>> asked;

    private final StudioModel model = new StudioModel(STUDIO, null);
    private final RaySection section = new RaySection(model, () -> {}, taker -> asked = taker, path -> {});
    private final Container content = (Container) section.component();
    private final DiagramPane diagram = Components.find(content, DiagramPane.class, "Space-time diagram");
    private final JToggleButton camera = Components.find(content, JToggleButton.class, "Camera frame");

    @BeforeAll
    static void look() {
        Look.LIGHT.install();
    }

    private PixelReading reading() {
        return PixelReading.of(Pictures.black(STUDIO), new Point2D.Double(32, 24));
    }

    @Test
    void theFrameThatWasChosenStaysForTheNextRay() {
        PixelReading reading = reading();
        WindowDriver.onEventThread(() -> {
            section.show(reading, null);
            assertThat(diagram.getToolTipText()).contains("in the scene frame");
            camera.doClick();
            assertThat(diagram.getToolTipText()).contains("in the camera frame");
            section.show(reading, null);
            assertThat(diagram.getToolTipText()).contains("in the camera frame");
        });
    }

    @Test
    void whatWasDeletedCannotBeEdited() {
        JButton edit = Components.find(content, JButton.class, Texts.get("ray.edit"));
        PixelReading reading = reading();
        WindowDriver.onEventThread(() -> {
            section.show(reading, null);
            assertThat(edit.isEnabled()).isTrue();
            model.set(STUDIO.withScene(List.of()));
            edit.doClick();
            assertThat(edit.isEnabled()).isFalse();
        });
    }

    @Test
    void whatIsDrawnIsOneStepBack() {
        JButton draw = Components.find(content, JButton.class, Texts.get("ray.draw"));
        PixelReading reading = reading();
        WindowDriver.onEventThread(() -> {
            section.show(reading, null);
            draw.doClick();
            assertThat(model.studio().scene()).hasSize(STUDIO.scene().size() + 1);
            assertThat(model.studio().scene().get(STUDIO.scene().size()).description())
                    .isEqualTo("ray: Pixel 32, 24");
            model.undo();
            assertThat(model.studio()).isEqualTo(STUDIO);
            section.show(null, null);
            assertThat(draw.isEnabled()).isFalse();
        });
    }

    @Test
    void aConeIsFollowedForTheScene() {
        JButton draw = Components.find(content, JButton.class, Texts.get("ray.cone"));
        List<SampleHistory> cone = RayTubes.cone(RenderPlan.of(STUDIO), 32, 24, 12, SamplePositions.MIDDLE);
        PixelReading reading = reading();
        WindowDriver.onEventThread(() -> {
            section.show(reading, null);
            draw.doClick();
            assertThat(model.studio()).isEqualTo(STUDIO);
            asked.accept(cone);
            Group drawn = (Group) model.studio().scene().get(STUDIO.scene().size());
            assertThat(drawn.description()).isEqualTo("cone of rays: Pixel 32, 24");
            assertThat(drawn.objects()).hasSize(12);
        });
    }

    @Test
    void aRayWithoutEventsHasNoFrameToChoose() {
        PixelReading dark = new PixelReading(1, 2, new Sighting(STUDIO, 1.5, 2.5, null));
        PixelReading reading = reading();
        WindowDriver.onEventThread(() -> {
            section.show(dark, null);
            assertThat(diagram.isVisible()).isFalse();
            assertThat(camera.getParent().isVisible()).isFalse();
            section.show(reading, null);
            assertThat(diagram.isVisible()).isTrue();
            assertThat(camera.getParent().isVisible()).isTrue();
        });
    }
}
