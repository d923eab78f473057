// Formulas that do not bound their error: what they find is taken for certain.

fn certain_meeting(t: real) -> Meeting {
    return Meeting(t, t, t);
}

fn may_be_closest(hit: Hit, meeting: Meeting) -> bool {
    return meeting.t <= hit.t && meeting.t < MISS;
}

fn keep_nearer(hit: ptr<function, Hit>, meeting: Meeting, id: u32, row: u32) {
    if meeting.t < (*hit).t || (meeting.t == (*hit).t && id < (*hit).id) {
        (*hit).t = meeting.t;
        (*hit).id = id;
        (*hit).row = row;
    }
}

fn limit_of(hit: Hit) -> real {
    return hit.t;
}

fn is_in_doubt(hit: Hit) -> bool {
    return false;
}

fn load_doubt(index: u32, hit: ptr<function, Hit>) {
}

fn store_doubt(index: u32, hit: Hit) {
}

fn list_doubtful(index: u32, hit: Hit) {
}
