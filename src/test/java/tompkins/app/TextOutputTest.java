package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import tompkins.file.FileException;
import tompkins.io.StudioReader;
import tompkins.studio.Studio;

/** What happens to the file of {@code trace -o} and {@code measure -o} while the program works. */
class TextOutputTest {

    @TempDir
    private Path folder;

    private final StringWriter printed = new StringWriter();

    /** Writes two lines; between them something happens. */
    private void write(Runnable meanwhile, String... options) throws IOException {
        TextOutput output = CommandLine.populateCommand(new TextOutput(), options);
        output.check(Studio.DEFAULT, StudioReader.PIPE);
        output.write(new PrintWriter(printed, true), Stream.of("one", "two").peek(line -> meanwhile.run()));
    }

    private static void put(Path file, String text) {
        try {
            Files.writeString(file, text);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    @Test
    void aFileThatAppearsMeanwhileStays() throws IOException {
        Path file = folder.resolve("rays.csv");
        write(() -> put(file, "from somebody else"), "-o", file.toString());

        Path numbered = Path.of(printed.toString().strip());
        assertThat(Files.readString(file)).isEqualTo("from somebody else");
        assertThat(numbered).isNotEqualTo(file).hasParentRaw(folder);
        assertThat(Files.readString(numbered)).isEqualTo("one\ntwo\n");
        try (Stream<Path> left = Files.list(folder)) {
            assertThat(left).containsExactlyInAnyOrder(file, numbered);
        }
    }

    @Test
    void withForceItIsReplaced() throws IOException {
        Path file = folder.resolve("rays.csv");
        write(() -> put(file, "from somebody else"), "-o", file.toString(), "--force");

        assertThat(printed.toString().strip()).isEqualTo(file.toString());
        assertThat(Files.readString(file)).isEqualTo("one\ntwo\n");
    }

    @Test
    void aFailureNamesTheFile() {
        Path inner = folder.resolve("inner");
        Path file = inner.resolve("rays.csv");
        assertThatThrownBy(() -> {
                    Files.createDirectory(inner);
                    write(() -> remove(inner), "-o", file.toString());
                })
                .isInstanceOf(FileException.class)
                .hasMessageStartingWith(file + ": cannot be written: ");
    }

    private static void remove(Path folder) {
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path each : all.sorted((a, b) -> b.compareTo(a)).toList()) {
                Files.delete(each);
            }
        } catch (IOException goneAlready) {
            assertThat(folder).doesNotExist();
        }
    }
}
