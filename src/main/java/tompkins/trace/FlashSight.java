package tompkins.trace;

import java.util.List;
import tompkins.light.Pulse;
import tompkins.world.LitSpan;

/**
 * What a flash lamp does at a hit.
 *
 * @param lamp the number of the lamp: 1 is the first point light of the scene
 * @param flash when it shines
 * @param emission own time of the lamp at which light had to leave it to reach the hit; no number if none reaches it
 * @param isClear whether that light meets the side that is seen, with nothing in the way
 * @param isStraight whether the ray has come from the camera without a surface on the way
 * @param spans camera time, counted from that of the ray, in which the same direction shows light of the last flash, of
 *     the one before it and of the next two, if there are such; empty if there is none, or if the ray is not straight
 */
public record FlashSight(
        int lamp, Pulse flash, double emission, boolean isClear, boolean isStraight, List<LitSpan> spans) {

    /** Whether the lamp was on then; something may still have been in the way of the light. */
    public boolean isLit() {
        return flash.isLit(emission);
    }
}
