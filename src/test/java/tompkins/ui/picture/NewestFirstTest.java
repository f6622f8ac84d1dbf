package tompkins.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class NewestFirstTest {

    private final BlockingQueue<String> events = new LinkedBlockingQueue<>();

    private final Semaphore mayEnd = new Semaphore(0);

    private void work(String thing) {
        switch (thing) {
            case "wrong" -> throw new IllegalStateException();
            case "large" -> throw new OutOfMemoryError();
            case "deep" -> throw new StackOverflowError();
            case "long" -> {
                events.add("began");
                mayEnd.acquireUninterruptibly();
                events.add("did long");
            }
            default -> events.add("did " + thing);
        }
    }

    private String nextEvent() throws InterruptedException {
        return events.poll(10, TimeUnit.SECONDS);
    }

    @Test
    void theNewestTaskIsNextAndNoneAfterTheEnd() throws InterruptedException {
        NewestFirst<String> worker = new NewestFirst<>("test", this::work, (thing, error) -> events.add(thing));
        worker.submit("long");
        assertThat(nextEvent()).isEqualTo("began");
        worker.submit("first");
        worker.submit("second");
        worker.submit("third");
        mayEnd.release();
        assertThat(nextEvent()).isEqualTo("did long");
        assertThat(nextEvent()).isEqualTo("did third");
        worker.submit("long");
        assertThat(nextEvent()).isEqualTo("began");
        worker.submit("late");
        worker.close();
        worker.submit("later");
        mayEnd.release();
        assertThat(nextEvent()).as("not interrupted").isEqualTo("did long");
        assertThat(events.poll(300, TimeUnit.MILLISECONDS)).isNull();
    }

    @Test
    void workThatThrowsIsToldAndTheNextThingIsDone() throws InterruptedException {
        try (NewestFirst<String> worker = new NewestFirst<>(
                "test",
                this::work,
                (thing, error) -> events.add(thing + ": " + error.getClass().getSimpleName()))) {
            worker.submit("wrong");
            assertThat(nextEvent()).isEqualTo("wrong: IllegalStateException");
            worker.submit("large");
            assertThat(nextEvent()).isEqualTo("large: OutOfMemoryError");
            worker.submit("deep");
            assertThat(nextEvent()).isEqualTo("deep: StackOverflowError");
            worker.submit("good");
            assertThat(nextEvent()).isEqualTo("did good");
        }
    }
}
