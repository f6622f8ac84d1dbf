package tompkins.ui.widget;

/** Tells changes by the user from those by the program: controls tell of both alike. */
public final class Updating {

    private boolean active;

    /** The program changes controls. */
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
