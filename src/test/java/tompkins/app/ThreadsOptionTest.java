package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class ThreadsOptionTest {

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void referencesTakeNoMoreThreads(int threads) throws Exception {
        ThreadsOption option = CommandLine.populateCommand(new ThreadsOption(), "--threads=" + threads);
        Set<Thread> seen = ConcurrentHashMap.newKeySet();
        int sum = option.during(() -> IntStream.range(0, 200)
                .parallel()
                .peek(i -> seen.add(Thread.currentThread()))
                .map(i -> spend())
                .sum());
        assertThat(sum).isEqualTo(200);
        assertThat(seen).hasSizeBetween(1, threads);
    }

    private static int spend() {
        long end = System.nanoTime() + 200_000;
        while (System.nanoTime() < end) {
            Thread.onSpinWait();
        }
        return 1;
    }

    @Test
    void whatFailsInAThreadFailsAsItDid() {
        ThreadsOption option = new ThreadsOption();
        for (Throwable failure : new Throwable[] {new IOException("disk"), new OutOfMemoryError("memory")}) {
            assertThatThrownBy(() -> option.during(() -> {
                        if (failure instanceof Error error) {
                            throw error;
                        }
                        throw (Exception) failure;
                    }))
                    .isSameAs(failure);
        }
    }
}
