package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
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
import org.junit.jupiter.params.provider.EnumSource;
import org.w3c.dom.Node;
import tompkins.OnLinux;
import tompkins.file.FileException;

class AnimationWriterTest {

    private static final String SECOND_SCENE = "{\"time\": 2}";

    @TempDir
    private Path folder;

    private Path target(AnimationFormat format) {
        return folder.resolve(
                "film" + (format.endings().isEmpty() ? "" : format.endings().get(0)));
    }

    /** A film of as many frames, the first with {@link Samples#SCENE}, the others with {@link #SECOND_SCENE}. */
    private Path film(AnimationFormat format, int framesPerSecond, int frames) throws IOException {
        Path target = target(format);
        try (AnimationWriter animation = format.open(target, framesPerSecond, true)) {
            for (int i = 0; i < frames; i++) {
                animation.add(
                        Samples.levels(Samples.squares(22, 13, i)),
                        i == 0 ? Samples.INFO : new PhotographInfo("", "", SECOND_SCENE));
            }
            animation.finish();
        }
        return target;
    }

    private static int[] levels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    private static int[] levels(int frame) {
        return levels(Samples.levels(Samples.squares(22, 13, frame)));
    }

    @Test
    void gifHasAllFramesExactlyWhereColoursAreFew() throws IOException {
        ImageReader reader = Samples.jdkReader("gif", Files.readAllBytes(film(AnimationFormat.GIF, 25, 5)));

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
        Path gif = film(AnimationFormat.GIF, framesPerSecond, 4);
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
        ImageReader reader = Samples.jdkReader("gif", Files.readAllBytes(film(AnimationFormat.GIF, 25, 4)));
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
    void gifRefusesSidesThatItCannotHold() throws IOException {
        try (AnimationWriter animation = AnimationFormat.GIF.open(target(AnimationFormat.GIF), 25, true)) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> animation.add(Samples.levels(Samples.random(65536, 1, 1)), PhotographInfo.NONE))
                    .withMessageContaining("65535")
                    .withMessageContaining("65536 x 1");
        }
    }

    @Test
    void numberedPicturesHoldTheirScenes() throws IOException {
        Files.createDirectory(target(AnimationFormat.NUMBERED_PNG));

        Path film = film(AnimationFormat.NUMBERED_PNG, 25, 3);

        assertThat(Samples.names(film)).containsExactly("frame0000.png", "frame0001.png", "frame0002.png");
        for (int i = 0; i < 3; i++) {
            Path frame = film.resolve("frame000" + i + ".png");
            assertThat(levels(
                            Samples.jdkReader("png", Files.readAllBytes(frame)).read(0)))
                    .isEqualTo(levels(i));
            assertThat(PhotographFile.readScene(frame)).contains(i == 0 ? Samples.SCENE : SECOND_SCENE);
        }
        assertThat(Samples.names(folder)).containsExactly("film");
    }

    @Test
    @OnLinux
    void aLinkToAnEmptyFolderStaysAndTheFolderIsFilled() throws IOException {
        Path real = Files.createDirectory(folder.resolve("real"));
        Path link = Files.createSymbolicLink(target(AnimationFormat.NUMBERED_PNG), real);
        film(AnimationFormat.NUMBERED_PNG, 25, 2);
        assertThat(link).isSymbolicLink();
        assertThat(Samples.names(real)).hasSize(2);
    }

    @Test
    void aFolderWithContentIsLeftAlone() throws IOException {
        Path film = Files.createDirectory(target(AnimationFormat.NUMBERED_PNG));
        Files.writeString(film.resolve("mine.txt"), "mine");

        assertThatThrownBy(() -> film(AnimationFormat.NUMBERED_PNG, 25, 1))
                .isInstanceOf(FileException.class)
                .hasMessage(film + ": cannot be written: it exists; name a new or an empty folder");
        assertThat(Samples.names(film)).containsExactly("mine.txt");
    }

    @ParameterizedTest
    @EnumSource(names = "MP4", mode = EnumSource.Mode.EXCLUDE)
    void closedUnfinishedItLeavesWholeFilesAlone(AnimationFormat format) throws IOException {
        Path target = target(format);
        boolean file = format != AnimationFormat.NUMBERED_PNG;
        if (file) {
            Files.writeString(target, "old");
        }
        try (AnimationWriter animation = format.open(target, 25, true)) {
            animation.add(Samples.levels(Samples.squares(22, 13, 0)), Samples.INFO);
            animation.add(Samples.levels(Samples.squares(22, 13, 1)), Samples.INFO);
            assertThat(Samples.names(folder))
                    .as("work in progress")
                    .anyMatch(name -> file ? name.endsWith(".part") : name.equals("film"));
            // As a worker that is told to stop finds itself.
            Thread.currentThread().interrupt();
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }

        if (file) {
            assertThat(target).hasContent("old");
            assertThat(Samples.names(folder))
                    .containsExactly(target.getFileName().toString());
        } else {
            assertThat(Samples.names(target)).containsExactly("frame0000.png", "frame0001.png");
        }
    }

    @ParameterizedTest
    @EnumSource(names = "MP4", mode = EnumSource.Mode.EXCLUDE)
    void equalFramesGiveEqualBytesAndReplace(AnimationFormat format) throws IOException {
        Path film = film(format, 25, 3);
        Path first = Files.isDirectory(film) ? film.resolve("frame0001.png") : film;
        byte[] bytes = Files.readAllBytes(first);
        if (Files.isDirectory(film)) {
            for (String name : Samples.names(film)) {
                Files.delete(film.resolve(name));
            }
        }

        film(format, 25, 3);

        assertThat(first).hasBinaryContent(bytes);
        assertThat(Samples.names(folder)).hasSize(1);
    }

    @Test
    void wrongRatesNamesAndFoldersAreRefused() {
        Path gif = folder.resolve("film.gif");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> AnimationFormat.GIF.open(gif, 0, true))
                .withMessage("framesPerSecond must be a whole number from 1 to 60, was 0");
        assertThatIllegalArgumentException().isThrownBy(() -> AnimationFormat.GIF.open(gif, 61, true));
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
