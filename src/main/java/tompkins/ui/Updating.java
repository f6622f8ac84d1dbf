package tompkins.ui;

/** Tells changes by the user from those by the program: controls tell of both alike. */
final class Updating {

    private boolean active;

    /** The program changes controls. */
    void during(Runnable change) {
        boolean before = active;
        active = true;
        try {
            change.run();
        } finally {
            active = before;
        }
    }

    /** Reacts to a change of a control, unless it was the program's. */
    void unless(Runnable reaction) {
        if (!active) {
            reaction.run();
        }
    }
}
