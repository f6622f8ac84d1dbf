package tompkins.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class AskerTest {

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
        return events.poll(5, TimeUnit.MINUTES);
    }

    @Test
    void theNewestTaskIsNextAndNoneAfterTheEnd() throws InterruptedException {
        Asker worker = new Asker("test", error -> events.add("failed"));
        worker.submit(() -> work("long"));
        assertThat(nextEvent()).isEqualTo("began");
        worker.submit(() -> work("first"));
        worker.submit(() -> work("second"));
        worker.submit(() -> work("third"));
        mayEnd.release();
        assertThat(nextEvent()).isEqualTo("did long");
        assertThat(nextEvent()).isEqualTo("did third");
        worker.submit(() -> work("long"));
        assertThat(nextEvent()).isEqualTo("began");
        worker.submit(() -> work("late"));
        worker.close();
        worker.submit(() -> work("later"));
        mayEnd.release();
        assertThat(nextEvent()).as("not interrupted").isEqualTo("did long");
        assertThat(events.poll(300, TimeUnit.MILLISECONDS)).isNull();
    }

    @Test
    void workThatThrowsIsToldAndTheNextThingIsDone() throws InterruptedException {
        try (Asker worker =
                new Asker("test", error -> events.add(error.getClass().getSimpleName()))) {
            worker.submit(() -> work("wrong"));
            assertThat(nextEvent()).isEqualTo("IllegalStateException");
            worker.submit(() -> work("large"));
            assertThat(nextEvent()).isEqualTo("OutOfMemoryError");
            worker.submit(() -> work("deep"));
            assertThat(nextEvent()).isEqualTo("StackOverflowError");
            worker.submit(() -> work("good"));
            assertThat(nextEvent()).isEqualTo("did good");
        }
    }

    /** Of each subject the newest is answered, and nothing is told that nobody asks for any more. */
    @Test
    void theNewestQuestionOfEachSubjectWins() throws Exception {
        try (Asker asker = new Asker("test", error -> events.add("failed"))) {
            asker.ask("mouse", () -> answer("long"), events::add);
            assertThat(nextEvent()).isEqualTo("began");
            asker.ask("click", () -> answer("click"), events::add);
            asker.ask("mouse", () -> answer("second"), events::add);
            asker.ask("mouse", () -> answer("third"), events::add);
            asker.ask("pin", () -> answer("pin"), events::add);
            asker.drop("pin");
            assertThat(asker.isAsked("click")).isTrue();
            mayEnd.release();
            // two threads write them down: the answers are told on that of the events
            assertThat(List.of(nextEvent(), nextEvent(), nextEvent(), nextEvent(), nextEvent()))
                    .containsExactlyInAnyOrder("did long", "did click", "did third", "told click", "told third");
            assertThat(events.poll(300, TimeUnit.MILLISECONDS)).isNull();
            assertThat(asker.isAsked("click")).isFalse();
        }
    }

    private String answer(String thing) {
        work(thing);
        return "told " + thing;
    }

    @Test
    void aLongQuestionKnowsThatItIsOvertaken() throws InterruptedException {
        try (Asker asker = new Asker("test", error -> events.add("failed"))) {
            asker.ask(
                    "ruler",
                    wanted -> {
                        work("long");
                        events.add(wanted.getAsBoolean() ? "wanted" : "overtaken");
                        return "told";
                    },
                    events::add);
            assertThat(nextEvent()).isEqualTo("began");
            asker.ask("ruler", () -> answer("next"), events::add);
            mayEnd.release();
            assertThat(nextEvent()).isEqualTo("did long");
            assertThat(nextEvent()).isEqualTo("overtaken");
            assertThat(nextEvent()).isEqualTo("did next");
            assertThat(nextEvent()).isEqualTo("told next");
        }
    }
}
