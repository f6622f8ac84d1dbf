package tompkins.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.OnLinux;
import tompkins.image.Samples;

class PendingFileTest {

    @TempDir
    private Path folder;

    private static PendingFile written(Path target, String content) throws IOException {
        PendingFile pending = PendingFile.at(target, false);
        try (OutputStream out = pending.open()) {
            out.write(content.getBytes(StandardCharsets.UTF_8));
        }
        return pending;
    }

    @Test
    @OnLinux
    void whatAppearsMeanwhileIsNotReplaced() throws IOException {
        Path target = folder.resolve("a.b.png");
        PendingFile pending = written(target, "mine");
        Files.writeString(target, "another's");
        Files.createSymbolicLink(folder.resolve("a.b-2.png"), folder.resolve("nothing"));
        Files.createDirectory(folder.resolve("a.b-3.png"));

        Path place = pending.commit();

        assertThat(place).isEqualTo(folder.resolve("a.b-4.png")).hasContent("mine");
        assertThat(target).hasContent("another's");
        assertThat(Samples.names(folder)).containsExactlyInAnyOrder("a.b.png", "a.b-2.png", "a.b-3.png", "a.b-4.png");
    }

    @Test
    void thoseWhoComeTogetherLoseNothing() throws Exception {
        Path target = folder.resolve("one.png");
        int many = 24;
        CountDownLatch start = new CountDownLatch(1);
        List<CompletableFuture<Path>> places = IntStream.range(0, many)
                .mapToObj(i -> CompletableFuture.supplyAsync(() -> committed(target, "number " + i, start)))
                .toList();
        start.countDown();

        for (int i = 0; i < many; i++) {
            assertThat(places.get(i).get()).hasContent("number " + i);
        }
        assertThat(Samples.names(folder)).hasSize(many);
    }

    private static Path committed(Path target, String content, CountDownLatch start) {
        try {
            PendingFile pending = written(target, content);
            start.await();
            return pending.commit();
        } catch (IOException | InterruptedException failure) {
            throw new IllegalStateException(failure);
        }
    }

    @Test
    @OnLinux
    void aPipeIsNeverReplaced() throws Exception {
        Path pipe = folder.resolve("pipe.png");
        assumeThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();

        assertThatThrownBy(() -> PendingFile.at(pipe, true))
                .hasMessage(pipe + ": cannot be written: it is a device or a pipe, not a file");
        assertThat(Files.readAttributes(pipe, "isOther").get("isOther")).isEqualTo(true);
    }

    /** What is written on would come back after it was removed. */
    @Test
    void whoeverWritesIsStoppedBeforeTheRestIsRemoved() throws IOException {
        PendingFile pending = PendingFile.at(folder.resolve("film.gif"), false);
        OutputStream open = pending.open();
        boolean[] stopped = {false};
        pending.stopAtEnd(() -> {
            assertThat(Samples.names(folder)).as("still there").hasSize(1);
            stopped[0] = true;
        });

        pending.close();

        assertThat(stopped[0]).isTrue();
        assertThatThrownBy(() -> {
                    open.write(new byte[1 << 20]);
                    open.flush();
                })
                .isInstanceOf(IOException.class);
        assertThatThrownBy(pending::open).isInstanceOf(InterruptedIOException.class);
        assertThatThrownBy(pending::commit).isInstanceOf(InterruptedIOException.class);
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aFolderGoesAgainIfNothingComesIntoIt() throws IOException {
        Path empty = folder.resolve("empty");
        OutputFolder unused = OutputFolder.at(empty);
        assertThat(empty).isDirectory();
        unused.close();
        assertThat(empty).doesNotExist();

        OutputFolder used = OutputFolder.at(empty);
        Files.writeString(empty.resolve("a"), "a");
        used.close();
        OutputFolder.at(empty).close();
        assertThat(empty.resolve("a")).exists();

        assertThatThrownBy(() -> OutputFolder.at(empty.resolve("a")))
                .hasMessage(empty.resolve("a") + ": cannot be written: it is a file, not a folder");
        assertThatThrownBy(() -> OutputFolder.at(folder.resolve("no/deep")))
                .hasMessage(
                        folder.resolve("no/deep") + ": cannot be written: there is no folder " + folder.resolve("no"));
    }
}
