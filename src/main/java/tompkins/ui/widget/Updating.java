package tompkins.ui.widget;

/** Distinguishes changes by the user from those by the program, because controls report both alike. */
public final class Updating {

    private boolean active;

    /** Lets the program change controls. */
    public void during(Runnable change) {
        boolean before = active;
        active = true;
        try {
            change.run();
        } finally {
            active = before;
        }
    }

    /** Reacts to a change of a control, unless it was the program's. */
    public void unless(Runnable reaction) {
        if (!active) {
            reaction.run();
        }
    }
}
