package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.image.AnimationFormat;
import tompkins.image.PhotographFile;
import tompkins.io.StudioReader;
import tompkins.render.Quality;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;

class AnimationTest {

    private static final Quality ONE_SAMPLE = new Quality.Samples(1);

    @TempDir
    private Path folder;

    @BeforeAll
    static void look() {
        Look.LIGHT.install();
    }

    private static Animation speed(Animation.Course course) {
        return new Animation(NumberProperty.speed(SpeedScale.BETA), 0, 0.8, 0.4, course);
    }

    @Test
    void coursesRunForwardsBackAndThereAndBack() {
        assertThat(speed(Animation.Course.FORWARDS).value(0.25)).isCloseTo(0.2, within(1e-12));
        assertThat(speed(Animation.Course.BACKWARDS).value(0.25)).isCloseTo(0.6, within(1e-12));
        assertThat(speed(Animation.Course.THERE_AND_BACK).value(0.25)).isCloseTo(0.4, within(1e-12));
        assertThat(speed(Animation.Course.THERE_AND_BACK).value(0.5)).isEqualTo(0.8);
    }

    @Test
    void filesHaveAllFramesAndLoopsDoNotRepeatTheFirst() {
        assertThat(speed(Animation.Course.FORWARDS).frames()).isEqualTo(10);
        assertThat(speed(Animation.Course.FORWARDS).timeOf(9)).isEqualTo(1);
        assertThat(speed(Animation.Course.THERE_AND_BACK).timeOf(9)).isEqualTo(0.9);
    }

    @Test
    void everyNumberOfTheSceneCanRun() {
        List<NumberProperty> properties = NumberProperty.of(Studios.sphere());
        NumberProperty radius = properties.stream()
                .filter(property -> property.name().equals("Scene \u203a sphere \u203a Radius"))
                .findFirst()
                .orElseThrow();
        Studio larger = radius.with().apply(Studios.sphere(), 2.0);
        assertThat(((Sphere) larger.scene().get(0)).radius()).isEqualTo(2);
        for (NumberProperty property : properties) {
            double value = property.get().applyAsDouble(Studios.sphere());
            Studio same = property.with().apply(Studios.sphere(), value);
            assertThat(property.get().applyAsDouble(same)).as(property.name()).isEqualTo(value);
        }
    }

    @Test
    void framesHoldTheirOwnScenes() throws Exception {
        Path frames = folder.resolve("frames");
        AnimationExport.write(
                Studios.sphere(),
                ONE_SAMPLE,
                speed(Animation.Course.FORWARDS),
                frames,
                AnimationFormat.NUMBERED_PNG,
                progress());
        try (Stream<Path> files = Files.list(frames)) {
            assertThat(files).hasSize(10);
        }
        String last = PhotographFile.readScene(frames.resolve("frame0010.png")).orElseThrow();
        assertThat(StudioReader.read(last, "last", folder).velocity())
                .isEqualTo(Velocity.of(SpeedScale.BETA, 0.8, new Vector3d(0, 0, 1)));
    }

    @Test
    void aCancelledAnimationLeavesNothing() throws IOException {
        Progress cancelled = new Progress() {
            @Override
            public void setProgress(double share) {}

            @Override
            public boolean isCancelled() {
                return true;
            }
        };
        assertThatThrownBy(() -> AnimationExport.write(
                        Studios.lattice(),
                        ONE_SAMPLE,
                        speed(Animation.Course.FORWARDS),
                        folder.resolve("a.gif"),
                        AnimationFormat.GIF,
                        cancelled))
                .isInstanceOf(CancellationException.class);
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).isEmpty();
        }
    }

    private static Progress progress() {
        return new Progress() {
            @Override
            public void setProgress(double share) {
                assertThat(share).isBetween(0.0, 1.0 + 1e-9);
            }

            @Override
            public boolean isCancelled() {
                return false;
            }
        };
    }
}
