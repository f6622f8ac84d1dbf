package tompkins.render;

import java.util.function.Consumer;

/** Listeners for tests. */
final class Looks {

    private Looks() {}

    /** A listener that looks at the job after each pass. */
    static RenderListener afterEachPass(Consumer<RenderJob> look) {
        return new RenderListener() {
            @Override
            public void passDone(RenderJob job) {
                look.accept(job);
            }
        };
    }
}
