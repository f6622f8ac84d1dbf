package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tompkins.app.ProgramRun.FIG1B;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.OnLinux;

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

        Path unused = folder.resolve("unused");
        assertThat(ProgramRun.of("render", "nothing.json", "-o", unused + "/").code())
                .isEqualTo(Failures.MISTAKE);
        assertThat(unused).doesNotExist();
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
                .hasMessage(
                        target + ": there is another file of this name; the command render replaces it with --force");
        assertThat(folder)
                .isDirectoryNotContaining(file -> !List.of(scene, target).contains(file));
        assertThat(target).hasBinaryContent(other);
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
}
