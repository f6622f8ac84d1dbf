package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Node;
import tompkins.file.FileException;

class AnimationWriterTest {

    @TempDir
    private Path folder;

    private Path gif() {
        return folder.resolve("film.gif");
    }

    /** A GIF of as many frames. */
    private Path film(int framesPerSecond, int frames) throws IOException {
        try (AnimationWriter animation = AnimationFormat.GIF.open(gif(), framesPerSecond, true)) {
            for (int i = 0; i < frames; i++) {
                animation.add(Samples.levels(Samples.squares(22, 13, i)));
            }
            return animation.finish();
        }
    }

    private static int[] levels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    private static int[] levels(int frame) {
        return levels(Samples.levels(Samples.squares(22, 13, frame)));
    }

    @Test
    void gifHasAllFramesExactlyWhereColoursAreFew() throws IOException {
        ImageReader reader = Samples.jdkReader("gif", Files.readAllBytes(film(25, 5)));

        assertThat(reader.getNumImages(true)).isEqualTo(5);
        for (int i = 0; i < 5; i++) {
            assertThat(levels(reader.read(i))).as("frame %d", i).isEqualTo(levels(i));
        }
    }

    @ParameterizedTest
    @CsvSource({"25, 4 4 4 4", "1, 100 100 100 100", "30, 3 4 3 3", "40, 3 2 3 2", "50, 2 2 2 2"})
    void gifKeepsTimeInHundredthsOfASecond(int framesPerSecond, String delays) throws IOException {
        assertThat(gifDelays(framesPerSecond)).isEqualTo(delays);
    }

    private String gifDelays(int framesPerSecond) throws IOException {
        Path gif = film(framesPerSecond, 4);
        ImageReader reader = Samples.jdkReader("gif", Files.readAllBytes(gif));
        List<String> found = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            Node control = metadata(reader, i, "GraphicControlExtension");
            found.add(control.getAttributes().getNamedItem("delayTime").getNodeValue());
        }
        return String.join(" ", found);
    }

    @Test
    void gifPlaysForEver() throws IOException {
        ImageReader reader = Samples.jdkReader("gif", Files.readAllBytes(film(25, 4)));
        IIOMetadataNode loop = (IIOMetadataNode) metadata(reader, 0, "ApplicationExtension");
        assertThat(loop.getAttribute("applicationID")).isEqualTo("NETSCAPE");
        assertThat((byte[]) loop.getUserObject()).containsExactly(1, 0, 0);
    }

    private static Node metadata(ImageReader reader, int frame, String element) throws IOException {
        IIOMetadataNode root =
                (IIOMetadataNode) reader.getImageMetadata(frame).getAsTree("javax_imageio_gif_image_1.0");
        return root.getElementsByTagName(element).item(0);
    }

    @Test
    void closedUnfinishedItLeavesTheFileAlone() throws IOException {
        Files.writeString(gif(), "old");
        try (AnimationWriter animation = AnimationFormat.GIF.open(gif(), 25, true)) {
            animation.add(Samples.levels(Samples.squares(22, 13, 0)));
            animation.add(Samples.levels(Samples.squares(22, 13, 1)));
            assertThat(Samples.names(folder)).as("work in progress").anyMatch(name -> name.endsWith(".part"));
            // As a worker that is told to stop finds itself.
            Thread.currentThread().interrupt();
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
        assertThat(gif()).hasContent("old");
        assertThat(Samples.names(folder)).containsExactly("film.gif");
    }

    @Test
    void equalFramesGiveEqualBytesAndReplace() throws IOException {
        byte[] bytes = Files.readAllBytes(film(25, 3));
        assertThat(film(25, 3)).hasBinaryContent(bytes);
        assertThat(Samples.names(folder)).hasSize(1);
    }

    @Test
    void wrongRatesNamesAndFoldersAreRefused() {
        Path gif = gif();
        assertThatThrownBy(() -> AnimationFormat.GIF.open(gif, 51, true))
                .isInstanceOf(FileException.class)
                .hasMessage(gif + ": an animated GIF can show at most 50 pictures a second, the film has 51;"
                        + " give the film fewer, or save it as .mp4 or as a folder of pictures");
        assertThatThrownBy(() -> AnimationFormat.MP4.open(gif, 25, true))
                .isInstanceOf(FileException.class)
                .hasMessage(gif + ": the name of an MP4 video must end in .mp4");
        Path lost = folder.resolve("lost").resolve("film.gif");
        assertThatThrownBy(() -> AnimationFormat.GIF.open(lost, 25, true))
                .isInstanceOf(FileException.class)
                .hasMessage(lost + ": cannot be written: there is no folder " + lost.getParent());
    }
}
