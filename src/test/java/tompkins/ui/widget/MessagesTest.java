package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class MessagesTest {

    @Test
    void memoryThatIsTooSmallIsSaidInWordsWhereverItRanOut() {
        Throwable memory = new OutOfMemoryError("Java heap space");
        for (Throwable failure : new Throwable[] {memory, new IllegalStateException("pixel 1,2", memory)}) {
            assertThat(Messages.of(failure))
                    .startsWith("Not enough memory: Java may use ")
                    .doesNotContain("heap", "pixel");
        }
        assertThat(Messages.of(new IllegalStateException("pixel 1,2"))).isEqualTo("pixel 1,2");
        assertThat(Messages.of(new IllegalStateException())).isEqualTo("java.lang.IllegalStateException");
    }
}
