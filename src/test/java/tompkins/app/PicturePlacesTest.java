package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;
import static tompkins.app.ProgramRun.FIG1B;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.OnLinux;
import tompkins.image.PictureFormat;
import tompkins.io.StudioReader;
import tompkins.render.Quality;
import tompkins.studio.Studio;

/** Where pictures are saved, and the names and places at which none may be. */
class PicturePlacesTest {

    @TempDir
    private Path folder;

    @Test
    @OnLinux
    @Timeout(600)
    void unwritablePlacesAreRefusedFirst() throws IOException {
        Path missing = folder.resolve("no");
        assertThat(refusalOf(missing.resolve("picture.png"))).isEqualTo("there is no folder " + missing);
        assertThat(folder).isEmptyDirectory();

        Path file = Files.writeString(folder.resolve("file"), "no folder");
        assertThat(refusalOf(file.resolve("picture.png"))).isEqualTo("there is no folder " + file);

        Path closed = Files.createDirectory(folder.resolve("closed"));
        closed.toFile().setWritable(false);
        // the administrator may write everywhere but into the kernel's own folder
        Path locked = Files.isWritable(closed) ? Path.of("/sys") : closed;
        assertThat(refusalOf(locked.resolve("picture.png"))).isEqualTo("there is no permission");
    }

    @Test
    @Timeout(600)
    void namesTooLongForTheDiskAreRefusedFirst() {
        assertThat(refusalOf(folder.resolve("x".repeat(300) + ".png"))).isEqualTo("File name too long");
        assertThat(folder).isEmptyDirectory();
    }

    /** Why no picture can be written there. */
    private static String refusalOf(Path picture) {
        // would take hours
        ProgramRun run = ProgramRun.of("render", FIG1B, "-o", picture, "--samples", 1 << 20);

        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err()).startsWith(picture + ": cannot be written: ");
        return run.err().strip().substring((picture + ": cannot be written: ").length());
    }

    @Test
    void aFolderIsMadeForItsPicturesAndNotForMistakes() throws IOException {
        Path made = folder.resolve("made");
        assertThat(ProgramRun.of("render", FIG1B, "scenes/fig1a.json", "-o", made + "/", "--size", "8x6")
                        .code())
                .isZero();
        assertThat(made.resolve("fig1a.png")).exists();
        assertThat(made.resolve("fig1b.png")).exists();

        Path deep = folder.resolve("no/deep");
        ProgramRun tooDeep = ProgramRun.of("render", FIG1B, "-o", deep + "/");
        assertThat(tooDeep.code()).isEqualTo(Failures.MISTAKE);
        assertThat(tooDeep.err()).contains("there is no folder " + deep.getParent());

        Path unused = folder.resolve("unused");
        assertThat(ProgramRun.of("render", "nothing.json", "-o", unused + "/").code())
                .isEqualTo(Failures.MISTAKE);
        assertThat(unused).doesNotExist();
    }

    @Test
    @OnLinux
    @Timeout(600)
    void aPipeIsKeptByAllCommands() throws Exception {
        for (String name : List.of("pipe.png", "pipe.gif")) {
            Path pipe = folder.resolve(name);
            assumeThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                    .isZero();
            for (String force : List.of("--force", "--size=8x6")) {
                ProgramRun run = name.endsWith("png")
                        ? ProgramRun.of("render", FIG1B, "-o", pipe, force)
                        : ProgramRun.of("animate", FIG1B, "--from", 0, "--to", 0.5, "-o", pipe, force);
                assertThat(run.code()).isEqualTo(Failures.MISTAKE);
                assertThat(run.err()).contains(pipe + ": cannot be written: it is a device or a pipe, not a file");
            }
            assertThat(Files.isRegularFile(pipe)).isFalse();
        }
        assertThat(folder).isDirectoryNotContaining(file -> !file.toString().contains("pipe"));
    }

    /** What happens without a display. */
    @Test
    void photographOfTheSameSceneIsReplacedAndNothingElse() throws Exception {
        Path scene =
                Files.writeString(folder.resolve("mine.json"), "{ \"settings\": { \"width\": 8, \"height\": 6 } }");
        Path target = folder.resolve("mine.png");
        Photographer photographer = new Photographer(TompkinsCommand.commandLine(() -> false), 1);

        photographer.takeDefault(scene, folder);
        FileTime first = FileTime.fromMillis(0);
        Files.setLastModifiedTime(target, first);
        photographer.takeDefault(scene, folder);
        assertThat(Files.getLastModifiedTime(target)).isGreaterThan(first);

        ProgramRun.of("render", FIG1B, "-o", target, "--size", "8x6", "--force");
        byte[] other = Files.readAllBytes(target);
        assertThatThrownBy(() -> photographer.takeDefault(scene, folder))
                .hasMessage(target + ": there is a file of this name already; --force replaces it");
        assertThat(folder)
                .isDirectoryNotContaining(file -> !List.of(scene, target).contains(file));
        assertThat(target).hasBinaryContent(other);
    }

    /** As by another process that takes the picture of the same name. */
    @Test
    void aNameThatIsTakenMeanwhileIsLeftToTheOther() throws Exception {
        Path scene = Files.writeString(folder.resolve("sky.json"), "{\"settings\": {\"width\": 8, \"height\": 6}}");
        Path target = folder.resolve("sky.png");
        Studio studio = StudioReader.read(scene);
        AtomicInteger asked = new AtomicInteger();
        try (Photographer photographer = new Photographer(TompkinsCommand.commandLine(() -> false), 1)) {
            photographer.take(
                    new Photographer.Order(scene, studio, Quality.of(studio), target, PictureFormat.PNG), () -> {
                        if (asked.incrementAndGet() == 2) {
                            assertThatCode(() -> Files.writeString(target, "of the other"))
                                    .doesNotThrowAnyException();
                        }
                        return false;
                    });
        }
        assertThat(target).hasContent("of the other");
        assertThat(StudioReader.read(folder.resolve("sky-2.png"))).isEqualTo(studio);
    }

    /** A photograph is what is inside, whatever the name says: only of one the picture is another one. */
    @Test
    void onlyThePictureOfAPhotographIsCalledAnother() throws IOException {
        for (String name : List.of("lesson.v2", "FIG.JSON", "plain")) {
            Path scene = Files.writeString(folder.resolve(name), "{ }");
            ProgramRun run = ProgramRun.of("render", scene, "--size", "8x6", "-o", folder);
            assertThat(run.out()).startsWith(folder.resolve(name.replaceFirst("[.].*", "")) + ".png  (");
        }
        ProgramRun again = ProgramRun.of("render", folder.resolve("lesson.png"), "-o", folder);
        assertThat(again.out()).startsWith(folder.resolve("lesson-again.png") + "  (");
    }

    @Test
    @OnLinux
    void thePlaceOfAPictureIsToldWithoutDetours() throws IOException {
        Path inner = Files.createDirectory(folder.resolve("inner"));
        Path detour = inner.resolve("..").resolve(".").resolve("short.png");

        ProgramRun run = ProgramRun.of("render", FIG1B, "--size", "8x6", "-o", detour);

        assertThat(run.out()).startsWith(folder.resolve("short.png") + "  (");
        Files.createSymbolicLink(folder.resolve("link"), Files.createDirectory(inner.resolve("deep")));
        ProgramRun throughLink = ProgramRun.of(
                "render",
                FIG1B,
                "--size",
                "8x6",
                "-o",
                folder.resolve("link").resolve("..").resolve("linked.png"));
        assertThat(inner.resolve("linked.png")).exists();
        assertThat(throughLink.out())
                .doesNotStartWith(folder.resolve("linked.png").toString());
    }

    @Test
    void anExistingFileIsKept() throws IOException {
        Path picture = Files.writeString(folder.resolve("mine.png"), "mine");

        ProgramRun run = ProgramRun.of("render", FIG1B, "-o", picture, "--size", "8x6");

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("mine.png").contains("--force");
        assertThat(Files.readString(picture)).isEqualTo("mine");
        assertThat(ProgramRun.of("render", FIG1B, "-o", picture, "--size", "8x6", "--force")
                        .code())
                .isZero();
        assertThat(Files.size(picture)).isGreaterThan(100);
    }

    @Test
    void twoScenesOfOneNameDoNotReplaceEachOther() throws IOException {
        Path other = Files.copy(Path.of("scenes/fig1a.json"), folder.resolve("fig1b.json"));
        Path pictures = Files.createDirectory(folder.resolve("pictures"));

        ProgramRun run = ProgramRun.of("render", FIG1B, other, "-o", pictures, "--size", "8x6", "--force");

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err().strip())
                .isEqualTo(other + ": its picture would be " + pictures.resolve("fig1b.png") + ", as that of " + FIG1B
                        + "; render one of them alone, with another name after -o");
        assertThat(pictures).isEmptyDirectory();
    }

    @Test
    void endingsOfNamesAreChecked() {
        ProgramRun run = ProgramRun.of("render", FIG1B, "-o", folder.resolve("picture.bmp"));

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("picture.bmp").contains(".png or .tif or .tiff or .hdr or .pic");
    }

    @Test
    void anEndingAloneIsNoName() {
        Path photograph = folder.resolve("photograph.png");
        ProgramRun.of("render", FIG1B, "-o", photograph, "--size", "8x6");
        Path nameless = folder.resolve(".png");
        Object[][] ways = {{FIG1B}, {photograph}, {FIG1B, "--format", "png16"}};
        for (Object[] way : ways) {
            List<Object> words = new ArrayList<>(List.of("render", "-o", nameless, "--size", "8x6"));
            words.addAll(List.of(way));

            ProgramRun run = ProgramRun.of(words.toArray());

            assertThat(run.code()).isEqualTo(2);
            assertThat(run.out()).isEmpty();
            assertThat(run.err()).startsWith(nameless + ": the name of a").contains(" is missing before the ending");
            assertThat(folder).isDirectoryNotContaining(file -> !file.equals(photograph));
        }
    }

    @Test
    void severalScenesGoIntoAFolder() {
        assertThat(ProgramRun.of("render", FIG1B, "scenes/fig1a.json", "-o", folder, "--size", "8x6")
                        .code())
                .isZero();
        assertThat(folder.resolve("fig1a.png")).exists();
        assertThat(folder.resolve("fig1b.png")).exists();
        ProgramRun run = ProgramRun.of("render", FIG1B, "scenes/fig1a.json", "-o", folder.resolve("one.png"));
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("folder");
    }
}
